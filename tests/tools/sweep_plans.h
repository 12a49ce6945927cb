// A small plan for tests of sweeps, and changes of it.
#pragma once

#include <string>

#include "chapters/sweep/sweep_jobs.h"

namespace crevice {

inline const std::string kSmallPlan = R"({
 "name": "small",
 "scenes": ["cornell"],
 "sizes": [[48, 27]],
 "methods": ["xjun", {"method": "gtao", "parameters": {"samples": [4, 8]}}],
 "parameters": {"ao_scale": [0.5, 1]},
 "seeds": [1000, 1001],
 "threads": [1, 2],
 "repetitions": 0,
 "reference_rays": 16
})";

// The plan with one text in the place of another, which it must hold.
inline std::string plan_with(const std::string& old_text, const std::string& new_text,
                             std::string plan = kSmallPlan) {
    const std::size_t at = plan.find(old_text);
    if (at == std::string::npos) throw std::logic_error("the plan has no " + old_text);
    return plan.replace(at, old_text.size(), new_text);
}

inline std::vector<SweepJob> jobs_of(const std::string& plan) {
    return sweep_jobs(plan_from_text(plan, "plan.json"), false, {});
}

}  // namespace crevice
