#include "chapters/view/frame_thread.h"

#include <algorithm>

#include "chapters/frame/frame_buffers.h"
#include "chapters/frame/parameter_words.h"
#include "chapters/lab/render_words.h"
#include "chapters/probe/probe_text.h"
#include "chapters/view/view_camera.h"

namespace crevice {

namespace {

bool is_of_truth(const std::string& buffer) { return buffer == kTruth || buffer == kAoError; }

// What must be drawn for these to be shown; the AO map where nothing else is wanted.
WantedBuffers wanted_for(const std::vector<std::string>& shown) {
    WantedBuffers wanted;
    for (const std::string& buffer : shown) wanted.insert(is_of_truth(buffer) ? "ao_blurred" : buffer);
    return wanted;
}

// With its values, which a picture on a page does without where the bytes say as much.
template <class Buffer>
Picture measurable_picture(const char* name, const Buffer& buffer, const Camera& camera) {
    Picture picture = buffer_picture(name, buffer, camera);
    if (picture.values.empty()) picture.values = planes_of(buffer);
    return picture;
}

void tell(const LoadedScene& scene, const DrawnFrame& drawn, ViewFrame& told) {
    told.error.clear();
    told.words = drawn.words;
    told.camera = drawn.camera;
    const Frame& frame = drawn.frame();
    told.passes = frame.passes;
    told.unchanged = drawn.worked.unchanged;
    told.tiles = frame.tiles;
    told.warnings = scene.warnings;
    for (const PrecisionLoss& loss : frame.precision) {
        if (!loss.warning.empty()) told.warnings.push_back("warning: " + loss.warning);
    }
    told.left_out.clear();
    for (const LeftOut& item : frame.left_out) told.left_out.push_back(item.what + ": " + item.why);
    for (const std::string& pass : told.unchanged) told.left_out.push_back(pass + ": " + kWhyUnchanged);
    for (const SkippedWork& work : frame.skipped) {
        if (work.count == 0) continue;
        told.left_out.push_back(std::string(skip_name(work.skip)) + ": " + std::to_string(work.count) +
                                " of " + std::to_string(work.of) + " " + work.unit);
    }
    told.pictures.clear();
    told.hashes.clear();
    for_each_buffer(frame, drawn.ndc_depth, drawn.words.only, [&](const char* name, const auto& buffer) {
        told.pictures.emplace_back(name, measurable_picture(name, buffer, frame.camera));
        told.hashes.emplace_back(name, content_hash(buffer));
    });
    told.parameters.clear();
    for (const Parameter<FrameSettings>& p : frame_parameters(*drawn.request.method))
        told.parameters.emplace_back(p.name, word_of(p, drawn.request.settings));
    told.truth.reset();
    told.pixel.reset();
    told.probe.clear();
}

}  // namespace

FrameThread::FrameThread(const Run& run) : session_(run), thread_([this] { this->run(); }) {}

FrameThread::~FrameThread() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void FrameThread::wish(const ViewWish& wish) {
    {
        const std::lock_guard lock(mutex_);
        wish_ = wish;
        is_new_ = true;
    }
    changed_.notify_one();
}

std::shared_ptr<const ViewFrame> FrameThread::newest() const {
    const std::lock_guard lock(mutex_);
    if (first_failure_ != nullptr) std::rethrow_exception(first_failure_);
    return newest_;
}

void FrameThread::publish() {
    auto copy = std::make_shared<const ViewFrame>(frame_);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(copy);
}

void FrameThread::run() {
    bool goes_on = false;
    for (;;) {
        ViewWish wish;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return ends_ || is_new_ || goes_on; });
            if (ends_) return;
            is_new_ = false;
            wish = *wish_;
        }
        try {
            goes_on = work(wish);
        } catch (const std::exception& error) {
            frame_.error = error.what();
            goes_on = false;
            if (frame_.drawn == 0) {
                const std::lock_guard lock(mutex_);
                first_failure_ = std::current_exception();
                return;
            }
            publish();
        }
    }
}

bool FrameThread::work(const ViewWish& wish) {
    if (wish.revision != seen_revision_) {
        seen_revision_ = wish.revision;
        draw(wish);
        publish();
    } else if (wish.pixel != frame_.pixel) {
        frame_.pixel = wish.pixel;
        frame_.probe = wish.pixel ? probe_text(session_.probe(wish.pixel->first, wish.pixel->second)) : "";
        publish();
    } else if (wish.truth) {
        const TruthSoFar truth = session_.cast_truth();
        if (truth.reference == nullptr) return true;
        frame_.truth = {truth.rays, truth.rmse, truth.bias, ao_picture(truth.reference->mean),
                        difference_picture(*truth.ao_error)};
        publish();
    }
    return wish.truth || wish.pixel != frame_.pixel;
}

void FrameThread::draw(const ViewWish& wish) {
    LabWords words = wish.words;
    words.only = wanted_for(wish.shown);
    if (wish.camera) {
        const LoadedScene& scene = session_.scene(words, wants_surfaces(words));
        words.camera = flags_of(scene.argument, *wish.camera, words.camera);
    }
    std::string asked = render_command(words);
    for (const std::string& buffer : words.only) asked += " " + buffer;
    if (asked == drawn_) {
        frame_.error.clear();
        return;
    }
    drawn_.clear();
    const DrawnFrame& drawn = session_.draw(words);
    drawn_ = asked;
    tell(session_.scene(words, false), drawn, frame_);
    ++frame_.drawn;
}

}  // namespace crevice
