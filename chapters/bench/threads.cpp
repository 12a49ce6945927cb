#include "chapters/bench/threads.h"

#include <map>

#include "chapters/frame/frame.h"
#include "chapters/study/statistics.h"
#include "chapters/terminal/progress.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

constexpr int kThreadPairs = 21;

}  // namespace

Table thread_table() {
    Table table{"scale_threads",
                {"pass", "one_ms", "two_ms", "speed_up", "low", "high", "confidence_%", "aim", "verdict"},
                {}};
    if (thread_count({}) < 2) return table;
    const Scene scene = columns_scene();
    FrameRequest request;
    request.size = {1280, 720};
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method, {});

    std::vector<std::string> names;
    std::map<std::string, std::vector<double>> one, two;
    Progress progress("threads", kThreadPairs + 1);
    for (int pair = 0; pair <= kThreadPairs; ++pair) {
        for (const int threads : {1, 2}) {
            request.run.threads = threads;
            for (const PassTime& pass : render_frame(scene, scene.camera, request).passes) {
                if (pair == 0 && threads == 1) names.push_back(pass.name);
                if (pair > 0) (threads == 1 ? one : two)[pass.name].push_back(pass.wall_ms);
            }
        }
        progress.advance();
    }
    for (const std::string& name : names) {
        const MedianInterval ratio = ratio_interval(one[name], two[name]);
        table.rows.push_back({name, TableValue(median(one[name]), 3), TableValue(median(two[name]), 3),
                              ratio.median, ratio.low, ratio.high, TableValue(100 * ratio.confidence, 1),
                              TableValue(kTwoThreadAim, 1), verdict_name(verdict(ratio, kTwoThreadAim))});
    }
    return table;
}

}  // namespace crevice
