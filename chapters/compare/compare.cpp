#include "chapters/compare/compare.h"

#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <utility>

#include "chapters/compare/compare_report.h"
#include "chapters/compare/compared_files.h"
#include "chapters/compare/compared_image.h"
#include "chapters/notebook/picture.h"
#include "chapters/terminal/output_directory.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/no_such.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/judge/flip.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

Image3 image3_of(Planes planes) {
    Image3 image;
    image.x = std::move(planes[0]);
    image.y = std::move(planes[1]);
    image.z = std::move(planes[2]);
    return image;
}

// Writes OUT/STEM.npy and, of one or three components, OUT/STEM.png, and says so.
void write_error_images(const Planes& a, const Planes& b, const fs::path& out, const std::string& stem,
                        std::ostream& report) {
    const fs::path npy = out / (stem + ".npy"), png = out / (stem + ".png");
    Planes difference = signed_difference(a, b);
    write_file_atomically(npy, npy_bytes(difference));
    if (difference.size() != 1 && difference.size() != 3) {
        report << "  " << npy.string() << "\n";
        return;
    }
    const Picture picture = difference.size() == 1 ? difference_picture(difference[0])
                                                   : difference_picture(image3_of(std::move(difference)));
    write_picture(png, picture);
    report << "  " << npy.string() << ", " << png.string() << ": " << picture.mapping << "\n";
}

// Values as a monitor is sent them. Throws InputError where they are no picture's.
Planes display_values(const DifferenceEntry& entry, Planes planes) {
    if (planes.size() != 1 && planes.size() != 3)
        throw InputError(entry.title() + ": FLIP is of one or three components (" +
                         std::to_string(planes.size()) + "); leave --flip out, or give limits a buffer");
    for (Image<float>& plane : planes) {
        const BufferStatistics statistics = buffer_statistics(plane);
        if (statistics.min < 0 || statistics.max > 1 || statistics.inf > 0)
            throw InputError(entry.title() + ": FLIP is of pictures, whose values lie in [0, 1] (" +
                             statistics_text(statistics) + "); leave --flip out, or give limits a buffer");
        if (!entry.linear_light) continue;
        for (float& value : plane.pixels) value = srgb_from_linear(value);
    }
    return planes;
}

double mean_flip(const DifferenceEntry& entry) {
    Planes a = display_values(entry, entry.a), b = display_values(entry, entry.b);
    if (a.size() == 1) return flip(a[0], b[0]).mean;
    return flip(image3_of(std::move(a)), image3_of(std::move(b))).mean;
}

ComparedPair compared(const DifferenceEntry& entry, const CompareLimits& limits) {
    ComparedPair pair{&entry, limits, {}, std::numeric_limits<double>::quiet_NaN(), {}};
    const Planes &a = entry.a, &b = entry.b;
    if (a.empty() || b.empty() || a.size() != b.size() || !(a[0].size == b[0].size)) {
        pair.failures.push_back(entry.note);
        pair.judged = !entry.unread;
        return pair;
    }
    pair.error = compare_images(a, b);
    try {
        if (limits.flip && !pair.error->failed()) pair.flip = mean_flip(entry);
        pair.failures = exceeded_limits(limits, *pair.error, pair.flip);
    } catch (const InputError& error) {
        pair.failures = {error.what()};
        pair.judged = false;
    }
    return pair;
}

// Throws InputError where limits are given of a buffer that neither side has: misspelt, they would hold nothing.
void require_known(const LimitsOfBuffers& limits, const fs::path& file,
                   std::span<const DifferenceEntry> entries) {
    std::vector<std::string> known;
    for (const DifferenceEntry& entry : entries) known.push_back(entry.buffer());
    for (const auto& [name, ignored] : limits.named) {
        if (std::ranges::find(known, name) != known.end()) continue;
        throw InputError(no_such(file.string(), "buffer on either side", name, known).what());
    }
}

LimitsOfBuffers limits_of(const CompareOptions& options, std::span<const DifferenceEntry> entries) {
    constexpr std::uintmax_t kMaxText = 1 << 20;
    std::error_code ignored;
    fs::path file = options.limits_file.value_or(options.b / kLimitsFile);
    if (!options.limits_file && !fs::is_regular_file(file, ignored)) return {options.limits, {}};
    LimitsOfBuffers limits = limits_from_text(read_file(file, kMaxText), file.string(), options.limits);
    require_known(limits, file, entries);
    return limits;
}

// What is copied from where to where, for one file of a pair of directories, or for the two files as they are.
struct Renewal {
    fs::path from, to;
};
Renewal renewal_of(const CompareOptions& options, const DifferenceEntry& entry, bool directories) {
    if (!directories) return {options.a, options.b};
    std::string file = entry.name;
    if (!entry.layer.empty()) file.resize(file.size() - entry.layer.size() - 2);  // ", normal"
    return {options.a / file, options.b / file};
}

bool holds_nan(const Planes& planes) {
    return std::ranges::any_of(planes, [](const Image<float>& p) { return buffer_statistics(p).nan > 0; });
}

void renew(const Renewal& renewal, std::ostream& report) {
    constexpr std::uintmax_t kMaxFile = std::uintmax_t{1} << 34;
    write_file_atomically(renewal.to, read_file(renewal.from, kMaxFile));
    report << renewal.to.string() << ": written from " << renewal.from.string() << "\n";
}

// Copies the files that failed from A over B; what is no golden stays, and is told. Whether all that failed was copied.
bool bless(const CompareOptions& options, std::span<const ComparedPair> pairs, bool directories,
           std::ostream& report) {
    std::error_code ignored;
    std::set<fs::path> renewed;
    bool all = true;
    for (const ComparedPair& pair : pairs) {
        if (pair.passed()) continue;
        const Renewal renewal = renewal_of(options, *pair.entry, directories);
        const std::string why = !fs::exists(renewal.from, ignored) ? "there is no " + renewal.from.string()
                                : !pair.judged                     ? pair.failures.front()
                                : holds_nan(pair.entry->a)
                                    ? renewal.from.string() + " holds NaN, which equals nothing"
                                    : "";
        if (!why.empty()) {
            report << renewal.to.string() << ": stays; " << why << "\n";
            all = false;
        } else if (renewed.insert(renewal.to).second) {
            renew(renewal, report);
        }
    }
    return all;
}

// A golden that is not there yet: --bless makes it of any image that can be read.
bool makes_first_golden(const CompareOptions& options) {
    std::error_code ignored;
    if (!options.bless || fs::exists(options.b, ignored) || !fs::is_regular_file(options.a, ignored))
        return false;
    compared_images(options.a, std::cerr);
    return true;
}

// An EXR and a directory hold the same in different files.
void require_blessable(const CompareOptions& options) {
    std::error_code ignored;
    if (!options.bless || fs::is_directory(options.a, ignored) == fs::is_directory(options.b, ignored))
        return;
    throw UsageError("--bless: copies files as they are, but of " + options.a.string() + " and " +
                     options.b.string() + " one is a directory; give two files or two directories");
}

}  // namespace

int compare_files(const CompareOptions& options, std::ostream& report) {
    // What blessing wrote is for people; the documents of programs stay whole.
    std::ostream& blessed = options.json ? std::cerr : report;
    if (makes_first_golden(options)) {
        renew({options.a, options.b}, blessed);
        return static_cast<int>(ExitCode::done);
    }
    require_blessable(options);
    for (const auto& file : {options.junit, options.html}) {
        if (file && file->has_parent_path()) try_output_directory(file->parent_path());
    }
    const std::vector<DifferenceEntry> entries = compared_entries(options.a, options.b, std::cerr);
    const LimitsOfBuffers limits = limits_of(options, entries);
    if (options.out) try_output_directory(*options.out);
    std::error_code ignored;
    const bool directories = fs::is_directory(options.a, ignored) && fs::is_directory(options.b, ignored);
    const bool several =
        directories || std::ranges::any_of(entries, [](const auto& e) { return !e.layer.empty(); });
    std::ostream silent(nullptr);
    std::ostream& text = options.json ? silent : report;
    std::vector<ComparedPair> pairs;
    long long failed = 0;
    for (const DifferenceEntry& entry : entries) {
        pairs.push_back(compared(entry, limits.of(entry.buffer())));
        const ComparedPair& pair = pairs.back();
        failed += !pair.passed();
        if (!several || !pair.passed()) print_pair(text, pair);
        if (!options.out || !pair.error || pair.error->identical()) continue;
        const std::string stem =
            (several ? entry.buffer() + "_error" : std::string("error")) + (entry.alpha ? "_alpha" : "");
        write_error_images(entry.a, entry.b, *options.out, stem, text);
    }
    if (several)
        text << failed << " of " << entries.size() << " differ"
             << (limits.any() ? " more than they may\n" : "\n");
    if (options.json) report << json_report(options.a.string(), options.b.string(), pairs);
    if (options.junit) write_file_atomically(*options.junit, junit_report(pairs));
    if (options.html) {
        write_file_atomically(*options.html, difference_page(entries));
        text << options.html->string() << "\n";
    }
    const bool passed = failed == 0 || (options.bless && bless(options, pairs, directories, blessed));
    bool judged = true;
    for (const ComparedPair& pair : pairs) {
        if (pair.judged) continue;
        judged = false;
        std::cerr << pair.failures.front() << "\n";
    }
    if (!judged) return static_cast<int>(ExitCode::input);
    return static_cast<int>(passed ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
