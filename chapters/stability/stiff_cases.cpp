#include "chapters/stability/stiff_cases.h"

#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "chapters/stability/stiff_scenes.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// The list that is built, of which a quick run takes what `essential` marks.
struct CaseList {
    bool quick;
    std::vector<StiffCase> cases = {};

    void add(bool essential, StiffCase one) {
        if (essential || !quick) cases.push_back(std::move(one));
    }
};

std::string number(double value) { return significant_text(value, 4); }

void add_scales(CaseList& list) {
    for (const int k : {-60, -40, -20, -8, 8, 20, 40, 60}) {
        list.add(k == -40 || k == 20, {"scale_2^" + std::to_string(k),
                                       "all lengths times 2^" + std::to_string(k) + ": the same bits",
                                       Answer::same, [k] { return scaled(corner_view(), k); }, corner_view});
    }
}

void add_far_origins(CaseList& list) {
    for (const double away : {1e4, 1e5, 1e6, 4e6}) {
        list.add(away == 1e5,
                 {"origin_" + number(away),
                  "scene and an eye that is no float moved by " + number(away) + " units: the same bits",
                  Answer::same, [away] { return moved(block_view(), away); }, block_view});
    }
}

void add_outliers(CaseList& list) {
    // At 1e7 floats are whole numbers: the block eight times as large has such corners.
    list.add(false, {"origin_1e+07",
                     "a larger block and an eye that is no float moved by 10,000,000 units: the same bits",
                     Answer::same, [] { return moved(scaled(block_view(), 3), 1e7); },
                     [] { return scaled(block_view(), 3); }});
    list.add(true, {"far_vertex", "a triangle a million units behind the eye: the same bits as without it",
                    Answer::same, [] { return far_vertex_view(); }, block_view});
}

void add_planes(CaseList& list) {
    for (const double degrees : {0.0, 60.0, 80.0, 85.0, 89.0, 89.9, 89.99}) {
        list.add(degrees == 60 || degrees == 89.9,
                 {"grazing_" + number(degrees), "a plane tilted by " + number(degrees) + " degrees",
                  Answer::open, [degrees] { return tilted_plane_view(degrees); }});
    }
    for (const double z : {1e3, 1e4, 1e5, 1e6}) {
        list.add(z == 1e5,
                 {"far_plane_" + number(z), "a plane at " + number(z) + " units through a narrow lens",
                  Answer::open, [z] { return far_plane_view(z); }});
    }
    for (const char* format : {"d16", "d24", "d32f", "d32f_reversed"}) {
        list.add(format == std::string("d32f"),
                 {std::string("ground_") + format,
                  std::string("a ground from behind the eye to the horizon, near 1e-4, far 4e5, depths in ") +
                      format,
                  Answer::open,
                  [format] {
                      StiffView view = ground_view();
                      view.params = {std::string("depth_format=") + format};
                      return view;
                  },
                  {},
                  0.5});
    }
    list.add(true, {"micro_triangles", "a plane of triangles smaller than a pixel", Answer::open,
                    [] { return tessellated_plane_view(400); }});
    list.add(false, {"screen_filling", "a triangle 10,000 times as large as the view", Answer::open,
                     [] { return huge_triangle_view(); }});
    list.add(true, {"slivers", "a plane cut into triangles a thousandth of a pixel wide", Answer::open,
                    [] { return sliver_plane_view(); }});
    list.add(true, {"coplanar", "the same plane twice", Answer::same,
                    [] { return doubled(tilted_plane_view(60)); }, [] { return tilted_plane_view(60); }});
    list.add(true, {"stretched_1e6", "a plane whose instance is stretched a millionfold along one axis",
                    Answer::open, [] { return stretched_plane_view(1e6); }});
    list.add(false, {"mirrored", "a scene mirrored with its camera: planes stay open", Answer::open,
                     [] { return mirrored_plane_view(); }});
}

void add_depths(CaseList& list) {
    for (const char* format : {"d16", "d24", "d32f", "d32f_reversed"}) {
        for (const auto& [near_plane, far_plane] :
             {std::pair(1.0, 1e3), std::pair(1e-2, 1e5), std::pair(1e-4, 1e7)}) {
            const bool essential = near_plane < 1e-3 && format != std::string("d24");
            list.add(essential,
                     {std::string("depth_") + format + "_" + number(near_plane) + "_" + number(far_plane),
                      std::string("a plane at 60 degrees, depths in ") + format + " from " +
                          number(near_plane) + " to " + number(far_plane),
                      Answer::open, [format, nearest = near_plane, farthest = far_plane] {
                          StiffView view = tilted_plane_view(60);
                          view.camera.near_plane = nearest;
                          view.camera.far_plane = farthest;
                          view.params = {std::string("depth_format=") + format};
                          return view;
                      }});
        }
    }
}

void add_settings(CaseList& list) {
    for (const double radius : {0.0, 1e-6, 1e-3}) {
        list.add(radius == 1e-6,
                 {"radius_" + number(radius), "a radius of " + number(radius) + ", where nothing is near",
                  Answer::open, [radius] {
                      StiffView view = block_view();
                      view.params = {"radius=" + number(radius), "ao_scale=1"};
                      return view;
                  }});
    }
    for (const double radius : {1e3, 1e6}) {
        list.add(radius == 1e3,
                 {"radius_" + number(radius), "a radius larger than everything", Answer::in_range, [radius] {
                      StiffView view = block_view();
                      view.params = {"radius=" + number(radius)};
                      return view;
                  }});
    }
    for (const char* words : {"exponent=0", "exponent=64", "blur_iterations=64", "seed=4294967295"}) {
        list.add(false, {words, std::string("a parameter at its end, ") + words, Answer::in_range, [words] {
                             StiffView view = block_view();
                             view.params = {words};
                             return view;
                         }});
    }
    for (const char* words : {"samples=0", "radius=-1", "exponent=65"}) {
        list.add(words == std::string("samples=0"),
                 {words, std::string("a parameter beyond its end, ") + words, Answer::refused, [words] {
                      StiffView view = block_view();
                      view.params = {words};
                      return view;
                  }});
    }
    for (const Size size : {Size{1, 1}, Size{1, 33}, Size{33, 1}, Size{5, 3}, Size{97, 65}}) {
        list.add(size.width == 5,
                 {"size_" + size_text(size), "a picture of " + size_text(size), Answer::open, [size] {
                      StiffView view = tilted_plane_view(0);
                      view.size = size;
                      return view;
                  }});
    }
}

void add_meshes(CaseList& list) {
    list.add(true, {"singular", "an instance flattened to nothing", Answer::background,
                    [] { return singular_view(); }});
    list.add(true, {"behind", "everything behind the eye", Answer::background, [] { return behind_view(); }});
    list.add(true, {"inside", "the eye inside a closed mesh whose back is not drawn", Answer::background,
                    [] { return inside_view(); }});
    list.add(false,
             {"on_surface", "the eye on a surface", Answer::in_range, [] { return on_surface_view(); }});
    for (const auto& [name, normal] :
         {std::pair("zero_normals", glm::vec3(0)), std::pair("opposite_normals", glm::vec3(0, -1, 0)),
          std::pair("nan_normals", glm::vec3(std::numeric_limits<float>::quiet_NaN()))}) {
        list.add(name == std::string("nan_normals"),
                 {name, std::string("vertex normals that are none: ") + name, Answer::in_range,
                  [normal = normal] { return with_normals(block_view(), normal); }});
    }
    list.add(false, {"intersecting", "planes through one another", Answer::in_range,
                     [] { return intersecting_view(); }});
}

// Those of the words that the method knows; the others ask for nothing that it has.
std::vector<std::string> known_words(const Method& method, const std::vector<std::string>& words) {
    std::vector<std::string> known;
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        for (const Parameter<FrameSettings>& parameter : frame_parameters(method)) {
            if (parameter.name == name) known.push_back(word);
        }
    }
    return known;
}

}  // namespace

FrameSettings settings_of(const StiffView& view, const Method& method) {
    return settings_of(method, known_words(method, view.params), view.scene.length_unit);
}

std::string stated_answer(const StiffCase& stiff) {
    std::string answer;
    switch (stiff.answer) {
        case Answer::open:
            answer = "every surface is open: mean accessibility 1, and within " + number(kStatedBias) +
                     " of it for what filtered depths and tilted planes cost";
            break;
        case Answer::same: answer = "the map of the other view, to the last bit"; break;
        case Answer::background: answer = "nothing is seen: 1 everywhere, to the last bit"; break;
        case Answer::in_range: answer = "no closed form: every value a number in [0,1]"; break;
        case Answer::refused: answer = "no map: the parameter is named and refused"; break;
    }
    if (stiff.covered) answer += "; surfaces cover " + percent_text(*stiff.covered) + " of the picture";
    return answer;
}

std::vector<StiffCase> stiff_cases(bool quick) {
    CaseList list{quick};
    add_scales(list);
    add_far_origins(list);
    add_outliers(list);
    add_planes(list);
    add_depths(list);
    add_settings(list);
    add_meshes(list);
    return std::move(list.cases);
}

}  // namespace crevice
