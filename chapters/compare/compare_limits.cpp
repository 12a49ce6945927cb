#include "chapters/compare/compare_limits.h"

#include <cmath>
#include <limits>
#include <vector>

#include "chapters/terminal/json_file.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

using Json = JsonFile::Json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class LimitsReader {
 public:
    LimitsReader(const std::string& text, const std::string& file) : file_(text, file, ExitCode::input) {}

    LimitsOfBuffers all(const CompareLimits& otherwise) const {
        LimitsOfBuffers limits{otherwise, {}};
        for (const auto& [key, value] : file_.root().items()) {
            if (key == "default") {
                limits.otherwise = of_buffer(value, key, {key});
            } else if (key == "limits") {
                if (!value.is_object()) fail("\"limits\" is not an object (" + json_line(value) + ")", {key});
                for (const auto& [buffer, of] : value.items())
                    limits.named[buffer] = of_buffer(of, buffer, {"limits", buffer});
            } else {
                fail("no such member (" + key + ")", {key});
            }
        }
        return limits;
    }

 private:
    CompareLimits of_buffer(const Json& of, const std::string& buffer, const JsonPlace& place) const {
        if (!of.is_object()) fail("no limits (" + buffer + ": " + json_line(of) + ")", place);
        CompareLimits limits;
        for (const auto& item : of.items()) {
            const std::string& name = item.key();
            const Json& value = item.value();
            const auto number = [&](double lowest, double highest) {
                const double read = value.is_number() ? value.get<double>() : kInfinity;
                if (!(read >= lowest && read <= highest) || std::isinf(read))
                    fail(buffer + ": " + name + " is out of range (" + json_line(value) + ")",
                         below(place, name));
                return read;
            };
            if (name == "max_abs") {
                limits.max_abs = number(0, kInfinity);
            } else if (name == "rmse") {
                limits.rmse = number(0, kInfinity);
            } else if (name == "flip") {
                limits.flip = number(0, 1);
            } else if (name == "ssim") {
                limits.ssim = number(-1, 1);
            } else if (name == "max_pixels") {
                if (!value.is_number_integer())
                    fail(buffer + ": max_pixels is no whole number (" + json_line(value) + ")",
                         below(place, name));
                limits.max_pixels = static_cast<long long>(number(0, 0x1p62));
            } else {
                fail(buffer + ": no such limit (" + name + ")", below(place, name));
            }
        }
        return limits;
    }

    [[noreturn]] void fail(const std::string& what, const JsonPlace& place) const {
        file_.refuse(what + "; " + kForm, place);
    }

    static constexpr const char* kForm =
        "give {\"limits\": {BUFFER: {...}}, \"default\": {...}} with max_abs, rmse, flip, ssim and "
        "max_pixels";
    const JsonFile file_;
};

}  // namespace

const CompareLimits& LimitsOfBuffers::of(const std::string& buffer) const {
    const auto found = named.find(buffer);
    return found == named.end() ? otherwise : found->second;
}

LimitsOfBuffers limits_from_text(const std::string& text, const std::string& file,
                                 const CompareLimits& otherwise) {
    return LimitsReader(text, file).all(otherwise);
}

std::vector<std::string> exceeded_limits(const CompareLimits& limits, const ImageError& error, double flip) {
    std::vector<std::string> lines;
    const auto check = [&](bool holds, const char* name, double value, double limit) {
        if (!holds)
            lines.push_back(std::string(name) + " " + significant_text(value, 6) + ", limit " +
                            significant_text(limit, 6));
    };
    if (error.failed())
        lines.push_back(counted(error.nan_or_inf, "pixel is", "pixels are") + " NaN or infinite");
    if (limits.max_abs) check(error.max_abs <= *limits.max_abs, "max", error.max_abs, *limits.max_abs);
    if (limits.rmse) check(error.rmse <= *limits.rmse, "RMSE", error.rmse, *limits.rmse);
    if (limits.flip) check(flip <= *limits.flip, "FLIP", flip, *limits.flip);
    if (limits.ssim) check(error.ssim >= *limits.ssim, "SSIM", error.ssim, *limits.ssim);
    if (limits.max_pixels && error.differing_pixels > *limits.max_pixels)
        lines.push_back(counted(error.differing_pixels, "pixel differs", "pixels differ") + ", limit " +
                        std::to_string(*limits.max_pixels));
    if (!limits.any() && error.differing_pixels > 0)
        lines.push_back(counted(error.differing_pixels, "pixel differs", "pixels differ") + ", limit 0");
    return lines;
}

}  // namespace crevice
