#include "chapters/report/scene_paragraph.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <span>

#include "chapters/report/contest.h"
#include "chapters/report/setting_words.h"
#include "chapters/study/error_points.h"
#include "chapters/sweep/error_terms.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

std::string phrase(const Contestant& one) { return setting_phrase(one.figures->setting); }
std::string number(double rmse) { return decimal_text(rmse, 4); }

// "an RMSE of 0.0400 ± 0.0020"
std::string rmse_text(const Contestant& one) {
    if (!(one.rmse() > 0)) return "an RMSE below the noise of the reference";
    return "an RMSE of " + number(one.rmse()) + " ± " + margin_words(one.errors().rmse_margin());
}

// " in 3.2 ms", where times are compared.
std::string time_text(const Contestant& one) {
    return one.time == nullptr ? "" : " in " + significant_text(one.ms(), 3) + " ms";
}

std::string within_noise(const Contest& contest) {
    return contest.ties == 2 ? "their difference is smaller than the noise"
                             : "their differences are smaller than the noise";
}

std::string capitalised(std::string sentence) {
    sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    return sentence;
}

// The first, and who ties with it.
std::span<const Contestant> winners(const Contest& contest) {
    return std::span(contest.ranking).first(contest.ties);
}

// "gtao with 4 samples has the least error, ...", or who ties for it.
std::string error_clause(const Contest& contest, const std::string& alone) {
    const Contestant& best = contest.ranking.front();
    if (contest.won()) {
        const std::string won = phrase(best) + " has the least error, " + rmse_text(best) + time_text(best);
        if (contest.ranking.size() == 1) return won + "; " + alone;
        const Contestant& second = contest.ranking[1];
        return won + ", ahead of " + phrase(second) + " (" + number(second.rmse()) + ")";
    }
    std::vector<std::string> tied;
    for (const Contestant& one : winners(contest)) {
        tied.push_back(phrase(one) + (tied.empty() ? " (RMSE " : " (") + number(one.rmse()) + " ± " +
                       margin_words(one.errors().rmse_margin()) + time_text(one) + ")");
    }
    return listed(tied) + " tie for the least error: " + within_noise(contest);
}

// In which step a winner gains most on the next; empty where it is not known.
std::string lead_sentence(const Contest& contest) {
    if (!contest.won() || contest.ranking.size() < 2) return "";
    const SettingErrors &best = contest.ranking[0].errors(), &second = contest.ranking[1].errors();
    const auto share_of = [](const SettingErrors& errors, const std::string& step) {
        double share = 0;
        for (const SweepErrorPart& part : errors.parts) share += part.step == step ? part.share : 0;
        return share;
    };
    std::string step;
    double most = 0;
    for (const SettingErrors* const either : {&second, &best}) {
        for (const SweepErrorPart& part : either->parts) {
            const double gain = share_of(second, part.step) - share_of(best, part.step);
            if (gain <= most) continue;
            most = gain;
            step = part.step;
        }
    }
    if (step.empty() || best.parts.empty() || second.parts.empty()) return "";
    return " Most of its lead lies in the step \"" + step + "\": a share of " +
           significant_text(share_of(best, step), 2) + " in the mean squared error against " +
           significant_text(share_of(second, step), 2) + ".";
}

// The largest part of each one's error.
std::string parts_sentence(std::span<const Contestant> all) {
    std::vector<std::string> parts;
    for (const Contestant& one : all) {
        const SweepErrorPart* const part = largest_part(one.errors().parts);
        if (part == nullptr) continue;
        double total = 0;
        for (const SweepErrorPart& other : one.errors().parts) total += other.share;
        if (!(total > 0)) continue;
        parts.push_back("\"" + part->step + "\" for " + phrase(one) + " (" +
                        decimal_text(100 * part->share / total, 0) +
                        (parts.empty() ? " % of the mean squared error)" : " %)"));
    }
    return parts.empty() ? "" : " The largest part of the error is " + listed(parts) + ".";
}

// One sentence for all budgets with the same winner and the same that follow it.
std::string budget_sentences(const std::vector<Contestant>& all) {
    std::vector<std::pair<std::string, Contest>> clauses;
    std::vector<std::vector<std::string>> budgets;
    for (const double budget : kBudgets_ms) {
        const Contest contest = least_error_within(all, budget);
        const std::string clause = contest.ranking.empty()
                                       ? "nothing is done"
                                       : error_clause(contest, "no other method is done by then");
        if (clauses.empty() || clauses.back().first != clause) {
            clauses.emplace_back(clause, contest);
            budgets.emplace_back();
        }
        budgets.back().push_back(significant_text(budget, 6));
    }
    std::string text;
    std::vector<Contestant> named;
    std::set<std::string> said;
    for (std::size_t i = 0; i < clauses.size(); ++i) {
        const auto& [clause, contest] = clauses[i];
        text += " Within " + listed(budgets[i]) + " ms " + clause + ".";
        if (contest.ranking.empty()) continue;
        const std::string lead = lead_sentence(contest);
        if (said.insert(lead).second) text += lead;
        for (const Contestant& winner : winners(contest)) {
            std::erase_if(named, [&](const Contestant& one) { return one.method() == winner.method(); });
            named.push_back(winner);
        }
    }
    return text + parts_sentence(named);
}

// "gtao with 8 samples comes first to an RMSE of 0.05, in 10 ms, ..."
std::string level_sentence(const Contest& contest, double level) {
    const Contestant& first = contest.ranking.front();
    const std::string level_text = "an RMSE of " + significant_text(level, 6);
    if (!contest.won()) {
        std::vector<std::string> tied;
        for (const Contestant& one : winners(contest))
            tied.push_back(phrase(one) + " (" + significant_text(one.ms(), 3) + " ms)");
        return " " + listed(tied) + " tie for the least time to " + level_text + ": " +
               within_noise(contest) + ".";
    }
    const std::string reached =
        " " + capitalised(level_text) + " is reached first by " + phrase(first) + "," + time_text(first);
    if (contest.ranking.size() == 1) return reached + "; no other method reaches it.";
    const Contestant& second = contest.ranking[1];
    return reached + ", " + significant_text(second.ms() / first.ms(), 2) + " times as fast as " +
           phrase(second) + ".";
}

std::string level_sentences(const std::vector<Contestant>& all, const std::optional<BarFigure>& same_again) {
    std::string text, missed;
    for (const double level : kErrorLevels) {
        const Contest contest = least_time_to(all, level, same_again);
        if (contest.ranking.empty()) {
            missed += (missed.empty() ? "" : " or ") + significant_text(level, 6);
        } else {
            text += level_sentence(contest, level);
        }
    }
    if (missed.empty()) return text;
    const Contestant nearest = least_error(all).ranking.front();
    return text + " Nothing reaches an RMSE of " + missed + "; " + phrase(nearest) + " comes nearest, with " +
           number(nearest.rmse()) + ".";
}

// One number of threads, over all budgets and levels of error.
std::string timed_sentences(const ViewFigures& view, int threads) {
    const std::vector<Contestant> all = contestants(view, threads);
    const std::optional<BarFigure> same_again = view.same_again(threads);
    std::string text = "\n\n**On " + counted(threads, "thread") + ".**";
    if (all.empty()) return text + " No setting has both a time and an error.";
    text += budget_sentences(all) + level_sentences(all, same_again);
    if (!same_again) return text;
    return text + " A setting that was timed as if it were two (A/A) took " +
           decimal_text(same_again->low, 3) + " to " + decimal_text(same_again->high, 3) +
           " times as long as itself: what is closer than that is a tie.";
}

std::string untimed_sentences(const ViewFigures& view) {
    const Contest contest = least_error(contestants(view, 0));
    if (contest.ranking.empty()) return " No error is known.";
    return " Nothing was timed here, so that only errors can be compared: " +
           error_clause(contest, "no other method was tried") + "." + lead_sentence(contest) +
           parts_sentence(winners(contest));
}

std::string failures(const ViewFigures& view) {
    std::vector<std::string> failed;
    for (const SettingFigures& figures : view.settings) {
        if (figures.failed_seeds() > 0) {
            failed.push_back(setting_phrase(figures.setting) + " (" +
                             counted(figures.failed_seeds(), "seed") + " of " +
                             std::to_string(figures.seeds.size()) + ")");
        }
    }
    if (failed.empty()) return "";
    return " Left out, because some of their pixels are no numbers, are images of " + listed(failed) + ".";
}

}  // namespace

std::string scene_paragraph(const ViewFigures& view) {
    std::set<std::string> methods;
    for (const SettingFigures& figures : view.settings) methods.insert(figures.setting.method);
    const std::string camera = view.view.camera.empty() ? "" : " (" + as_code(view.view.camera) + ")";
    std::string text = as_code(view.view.scene) + camera + " at " + size_text(view.view.size) + ", " +
                       counted(view.view.triangles, "triangle") + ": " +
                       counted(static_cast<long long>(view.settings.size()), "setting") + " of " +
                       counted(static_cast<long long>(methods.size()), "method") + "." + failures(view);
    if (view.threads.empty()) return text + untimed_sentences(view);
    for (const int threads : view.threads) text += timed_sentences(view, threads);
    return text;
}

}  // namespace crevice
