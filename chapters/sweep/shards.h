// A plan's jobs dealt to several machines.
#pragma once

#include <string>
#include <vector>

#include "chapters/sweep/sweep_jobs.h"

namespace crevice {

struct Shard {
    int number = 1, of = 1;  // number in 1 .. of
};

// "K/N". Throws UsageError.
Shard parse_shard(const std::string& flag, const std::string& word);

// The shard's jobs in the order in which they are best done: those that share a truth one after the other, time jobs last.
// Each job is in one shard of all. Shards have about the same work, error jobs and time jobs each; a truth is traced twice
// only where a shard ends between its jobs.
std::vector<SweepJob> dealt(std::vector<SweepJob> jobs, Shard shard);

}  // namespace crevice
