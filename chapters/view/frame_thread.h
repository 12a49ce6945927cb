// Draws what the window asks for on a thread of its own, so that the window never waits: always the newest wish, then, while
// nothing changes, the pixel that is asked about and some rays of truth more.
#pragma once

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "chapters/frame/left_out.h"
#include "chapters/lab/lab_session.h"
#include "chapters/notebook/picture.h"
#include "chapters/terminal/stopwatch.h"

namespace crevice {

// Beside the buffers that methods draw: what rays say, and how far the AO is off.
inline constexpr const char* kTruth = "truth";
inline constexpr const char* kAoError = "ao_error";

// What is to be seen. `words.only` is not looked at: it follows from the buffers.
struct ViewWish {
    LabWords words;
    std::optional<Camera> camera;              // where mouse and keys have brought it; none: as `words` say
    std::vector<std::string> shown;            // one buffer, or two side by side
    bool truth = false;                        // rays are cast while nothing changes
    std::optional<std::pair<int, int>> pixel;  // that is asked about
    int revision = 0;                          // another one where a frame must be drawn, not only told of

    bool same_work_as(const ViewWish& other) const {
        return revision == other.revision && truth == other.truth && pixel == other.pixel;
    }
};

struct ViewTruth {
    int rays = 0;  // a pixel
    double rmse = 0, bias = 0;
    Picture truth, ao_error;
};

// One frame as the window shows it. What could not be drawn says why in `error`, and the rest is that of the frame before.
struct ViewFrame {
    std::string error;
    LabWords words;  // that give the same bits again, camera and all
    Camera camera;
    std::vector<std::pair<std::string, Picture>> pictures;  // of wish.shown, but for truth
    // Of the same buffers, as `crevice render` tells them: names, and hashes.
    std::vector<std::pair<std::string, std::string>> hashes;
    std::vector<std::pair<std::string, std::string>> parameters;  // names, and words for their values
    std::vector<PassTime> passes;
    std::vector<std::string> unchanged;           // passes: WorkedFrame::unchanged
    std::vector<std::string> warnings, left_out;  // a line each
    FrameTiles tiles;
    std::optional<ViewTruth> truth;
    std::optional<std::pair<int, int>> pixel;
    std::string probe;  // of that pixel, as `crevice probe` tells it
    int drawn = 0;  // how many frames were drawn up to this one; the same when something was only added to it
};

class FrameThread {
 public:
    explicit FrameThread(const Run& run);
    ~FrameThread();
    FrameThread(const FrameThread&) = delete;
    FrameThread& operator=(const FrameThread&) = delete;

    void wish(const ViewWish& wish);
    // Null before the first frame. Throws what kept the first one from being drawn.
    std::shared_ptr<const ViewFrame> newest() const;

 private:
    void run();
    // The next piece of work for the present wish; false when there is none left.
    bool work(const ViewWish& wish);
    // Nothing where that would give the same frame.
    void draw(const ViewWish& wish);
    void publish();

    LabSession session_;
    ViewFrame frame_;  // the thread's own; published as copies
    int seen_revision_ = -1;
    std::string drawn_;  // what the frame was drawn for, in words

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<ViewWish> wish_;
    bool is_new_ = false, ends_ = false;
    std::shared_ptr<const ViewFrame> newest_;
    std::exception_ptr first_failure_;
    std::thread thread_;  // last: it uses all the others
};

}  // namespace crevice
