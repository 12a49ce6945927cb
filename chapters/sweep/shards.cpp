#include "chapters/sweep/shards.h"

#include <algorithm>
#include <map>

#include "chapters/sweep/sweep_words.h"
#include "chapters/terminal/parse.h"

namespace crevice {

namespace {

// Those of a list whose middle, as work goes on from the first to the last, lies in the shard's part of it.
std::vector<SweepJob> part_of(const std::vector<SweepJob>& jobs, Shard shard) {
    double all = 0, before = 0;
    for (const SweepJob& job : jobs) all += job.work;
    std::vector<SweepJob> part;
    for (const SweepJob& job : jobs) {
        const double middle = (before + job.work / 2) / all;
        before += job.work;
        const int number = 1 + std::min(static_cast<int>(middle * shard.of), shard.of - 1);
        if (number == shard.number) part.push_back(job);
    }
    return part;
}

}  // namespace

Shard parse_shard(const std::string& flag, const std::string& word) {
    constexpr int kMostShards = 1 << 20;
    const std::size_t slash = word.find('/');
    if (slash == std::string::npos)
        throw UsageError(flag + ": not K/N (" + word + "); write 1/4, 2/4, 3/4 and 4/4");
    const auto of = static_cast<int>(parse_whole(flag, word.substr(slash + 1), 1, kMostShards));
    return {static_cast<int>(parse_whole(flag, word.substr(0, slash), 1, of)), of};
}

std::vector<SweepJob> dealt(std::vector<SweepJob> jobs, Shard shard) {
    const auto first_timed =
        std::stable_partition(jobs.begin(), jobs.end(), [](const SweepJob& job) { return !job.timed; });
    std::vector<SweepJob> errors(jobs.begin(), first_timed), times(first_timed, jobs.end());
    // Views in the plan's order, and of each view the questions in the order in which they are first asked.
    std::map<std::string, std::size_t> first_asked;
    const auto truth_of = [](const SweepJob& job) { return words_of(job.view) + " " + job.asks; };
    for (const SweepJob& job : errors) first_asked.emplace(truth_of(job), first_asked.size());
    std::ranges::stable_sort(errors, {}, [&](const SweepJob& job) { return first_asked.at(truth_of(job)); });
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (i == 0 || truth_of(errors[i]) != truth_of(errors[i - 1])) errors[i].work += errors[i].truth_work;
    }
    std::vector<SweepJob> part = part_of(errors, shard);
    for (SweepJob& job : part_of(times, shard)) part.push_back(std::move(job));
    return part;
}

}  // namespace crevice
