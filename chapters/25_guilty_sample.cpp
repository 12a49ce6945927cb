// %% setup tags=["setup"]
// Source: this lab; the artifacts are those of X_Jun, Luna and LearnOpenGL.
// Run: crevice chapter 25
#include <algorithm>

#include "chapters/notebook/chapter.h"
#include "chapters/props/crops.h"
#include "chapters/props/marked_picture.h"
#include "chapters/props/number_words.h"
#include "chapters/props/probed_view.h"
#include "chapters/props/ray_judge.h"
#include "chapters/terminal/number_text.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

// X_Jun's columns, close beside one of them.
SwitchedView beside_column(const Notebook& book) {
    SwitchedView view(book, "columns");
    if (view.scene().name == "columns") {
        Camera camera = view.camera();
        camera.eye = {-7.4, -1.2, -7.2};
        camera.target = {-2.6, -1.9, -0.8};
        view.look(camera, "--eye -7.4,-1.2,-7.2 --target -2.6,-1.9,-0.8");
    }
    return view;
}

// A signed error with a ring around a texel.
Picture ringed(const Image<float>& error, const Texel& texel, float scale) {
    return with_ring(difference_picture(error, scale), {texel.x, texel.y});
}

// What the text says of a probed pixel and one of its samples.
void name_numbers(Notebook& book, const std::string& prefix, const PixelProbe& probe, std::size_t sample) {
    const ExplainedSample& s = probe.ao.explanation.samples[sample];
    book.number(prefix + "_x", std::to_string(probe.x));
    book.number(prefix + "_y", std::to_string(probe.y));
    book.number(prefix + "_texel_x", std::to_string(probe.ao.x));
    book.number(prefix + "_texel_y", std::to_string(probe.ao.y));
    book.number(prefix + "_ao", text(probe.ao.value));
    book.number(prefix + "_sample", std::to_string(sample));
    book.number(prefix + "_dz", text(s.dz));
    book.number(prefix + "_dp", text(s.dp));
    book.number(prefix + "_takes", text(s.contribution));
}

// The first of these texels whose guilty sample finds something farther in front than the radius.
Texel first_with_far_liar(const RayJudge& judge, const ProbedView& view, const std::vector<Texel>& texels) {
    const auto found = std::ranges::find_if(texels, [&](const Texel& texel) {
        const Explanation explained = view.explanation(texel);
        const std::optional<std::size_t> guilty = judge.guilty_sample(explained);
        return guilty && explained.samples[*guilty].dz > kXjunSettings.radius;
    });
    return found == texels.end() ? texels.at(0) : *found;
}

// The borders of which a single sample makes nine tenths and more.
std::vector<FalseBorder> made_by_one(const ProbedView& view, std::vector<FalseBorder> borders) {
    constexpr double kAlone = 0.9;
    std::erase_if(borders, [&](const FalseBorder& border) {
        return changed_most(view.explanation(border.dark), view.explanation(border.light)).share < kAlone;
    });
    return borders;
}

// How far apart the vectors of two texels are on average, scene units.
double mean_distance(const Explanation& a, const Explanation& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.samples.size(); ++i)
        sum += static_cast<double>(glm::distance(a.samples[i].offset, b.samples[i].offset));
    return sum / static_cast<double>(a.samples.size());
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void guilty_sample(Notebook& book) {

// %% question [markdown]
// # From the picture to the guilty sample
//
// Three pictures with something wrong in them. The open floor of the first one is full of dark grain. In the second, a
// column darkens ground that lies far behind it. In the third, the shade at the foot of a column has steps. Each picture is
// made of hundreds of thousands of samples, and nearly all of them are right. Which ones are not, and which number made
// them so?

// %% start
const SwitchedView whole(book, "columns"), beside = beside_column(book), foot = column_foot(book);
const Words no_dp = {"self_occlusion_test=false"}, no_range = {"fade_end=1e30"}, no_turn = {"random_vectors=none"};
book.number("rays", std::to_string(RayJudge::kRays));
const ProbedView acne(whole, no_dp), halo(beside, no_range), bands(foot, no_turn);
book.show_row({{"acne", ao_picture(acne.ao()), "*Acne*: planes darken themselves.", acne.render_command()},
               {"halo", ao_picture(halo.ao()), "A *halo*: a dark rim around what stands in front.",
                halo.render_command()},
               {"bands", ao_picture(bands.ao()), "*Banding*: hard borders where nothing has a border.",
                bands.render_command()}},
              "Raw AO maps, half as wide and high as the picture, each with one parameter set wrong.");

// %% idea [markdown]
// ## The idea
//
// **Let rays say which texel is most wrong, let rays say which of its samples lies, and read the numbers of that sample:
// they name the parameter.**
//
// Chapter 02 has cast rays for truth: the share of {rays} rays from a texel that meet nothing within the radius. The *signed
// error* of a map is the map minus that truth, which is raised to the map's own power 4 for contrast before. Where it is
// negative, the map is too dark. The clearest cases lie on *open planes*, where even rays twice as long meet nothing: whatever is
// dark there is wrong.
//
// A sample of chapter 06 goes from the point $p$ of the texel to a point $q$ in the air and asks the depth map for the surface
// $r$ behind or before it. Between $p$ and $q$ a ray can check the answer. If the sample takes light away although its ray
// meets nothing, it *lies*. The *guilty sample* of a texel is the liar that takes most.
//
// To find both is the program's work. To read the sample's numbers is yours, and there are three places for it: the terminal,
// the debugger, and the lab in the browser. All three run the same kernel for that texel, in plain floats, and hold the same
// bits.

// %% acne_found
const ProbedView acne_cured(whole, {});
const RayJudge floor_judge(whole, acne, book.seed());
const std::vector<Texel> grains = floor_judge.wrong_texels(acne, 0.1f), grains_left = floor_judge.wrong_texels(acne_cured, 0.1f);
const Texel dark = grains.at(0);
const PixelProbe on_floor = acne.probe(dark);
const Explanation& of_floor = on_floor.ao.explanation;
const std::size_t liar = floor_judge.guilty_sample(of_floor).value_or(0);
name_numbers(book, "acne", on_floor, liar);
book.numbers({{"grains", grains.size()}, {"grains_left", grains_left.size()}});
book.compare({"acne_again", ao_picture(acne.ao()), "Without dp: grain on every plane.", acne.render_command()},
             {"acne_cured", ao_picture(acne_cured.ao()), "With dp, as by default: open planes are white.",
              acne_cured.render_command()});
book.show({"acne_error", ringed(floor_judge.signed_error(acne), dark, 1),
           "The signed error of the map without dp: blue is too dark, red too bright. The green ring is around the darkest of the texels "
           "on open planes.", acne.probe_command(dark)});

// %% acne_terminal_text [markdown]
// ## Acne, in the terminal
//
// Texel ({acne_texel_x}, {acne_texel_y}) lies on an open plane, and yet the map says {acne_ao}. The texel lies under pixel
// ({acne_x}, {acne_y}) of the picture. `crevice probe` takes that pixel and prints every number that made it, the answer first;
// dots stand for lines that are left out here. It counts samples from 0.

// %% acne_terminal
book.transcript(acne.terminal_transcript(on_floor, liar),
                "The texel, and the row of its guilty sample. The columns are those of chapter 06.");
book.draw("acne_section", acne.section(on_floor, liar, "The guilty sample of the acne"),
          "The same sample in a cut through the depth buffer: r lies in the same plane as p, only nearer to the eye, which "
          "is at the left.");

// %% acne_reading [markdown]
// Read the row from right to left. The verdict is "occludes". *dz* says that $r$ lies {acne_dz} nearer to the eye than $p$,
// more than epsilon: that is true, and true of every plane that is seen at a slant. So the wrong number is *dp*, the
// cosine between the normal and the way to $r$. For two points of one plane it must be 0, and here it is {acne_dp}: nobody
// has computed it. The parameter is `self_occlusion_test`.

// %% acne_checked
const ExplainedSample cured_liar = acne_cured.explanation(dark).samples[liar];
book.numbers({{"acne_cured_dp", text(cured_liar.dp)}, {"acne_cured_ao", text(acne_cured.ao().at(dark.x, dark.y))}});
book.check("Sample {acne_sample} takes {acne_takes}, although the ray to its q meets nothing.",
           of_floor.samples[liar].contribution > 0 && floor_judge.is_free(of_floor, liar));
book.check("With the test, its dp is {acne_cured_dp}, and the texel has {acne_cured_ao}.",
           cured_liar.contribution < 0.01f && acne_cured.ao().at(dark.x, dark.y) > 0.95f);
book.check("Of {grains} texels of open planes that were darker than 0.9, {grains_left} are left.",
           grains_left.size() < grains.size() / 20);

// %% acne_debugger_text [markdown]
// ## Acne, in the debugger
//
// A debugger shows the same sample while it is made. Build the program for it first:
// `cmake --preset debug && cmake --build --preset debug --target crevice`. Then five commands lead to it. The first one starts
// GDB with the lab's own commands and printers; `run` draws the frame up to the kernel of this texel and stops there; `pixel`
// tells what every image of the frame holds there; `next` runs the kernel; `print told` shows what it has found.

// %% acne_debugger
book.transcript(acne.debugger_transcript(on_floor, liar),
                "What GDB prints has more lines; these are the ones to look at. The bits are those of the probe.");

// %% acne_debugger_on [markdown]
// With `kernel` in place of `next` you stand inside of the kernel, and `step` goes through it line by line: the line that
// computes dp is passed over.

// %% acne_browser_text [markdown]
// ## Acne, in the browser
//
// `./crevice.sh web` makes `lab.html` beside these pages. Every link *in the lab* under a picture opens it with the picture's
// scene, camera and parameters; the one below brings the pixel along. The table of samples stands under the
// picture there. Point to row {acne_sample}, and that sample lights up in the picture and in the cut; set
// `self_occlusion_test` back to `true`, and watch its contribution go.

// %% acne_browser
book.show({"acne_samples", acne.overlay(on_floor),
           "The samples around the pixel, which is framed in green: red ones occlude, blue rings do not. The red ones are all on "
           "the side that is nearer to the eye.", acne.probe_command(dark)});

// %% halo_title [markdown]
// ## A halo
//
// The same way once more, in fewer words. On the second picture we look for the darkest texel of an open plane whose guilty sample
// finds something farther in front of $p$ than the radius.

// %% halo_found
const ProbedView halo_cured(beside, {"fade_end=0.5"}), halo_published(beside, {});
const RayJudge rim_judge(beside, halo, book.seed());
const std::vector<Texel> rims = rim_judge.wrong_texels(halo, 0.1f), rims_left = rim_judge.wrong_texels(halo_cured, 0.1f);
const std::vector<Texel> rims_published = rim_judge.wrong_texels(halo_published, 0.1f);
const Texel rim = first_with_far_liar(rim_judge, halo, rims);
const PixelProbe on_rim = halo.probe(rim);
const Explanation& of_rim = on_rim.ao.explanation;
const std::size_t far_liar = rim_judge.guilty_sample(of_rim).value_or(0);
name_numbers(book, "halo", on_rim, far_liar);
const float radius = kXjunSettings.radius, radii = of_rim.samples[far_liar].dz / radius;
book.numbers(1, {{"halo_radii", static_cast<double>(radii)}, {"radius", static_cast<double>(radius)}});
book.numbers({{"rims", rims.size()}, {"rims_published", rims_published.size()}, {"rims_left", rims_left.size()}});
book.compare({"halo_again", ao_picture(halo.ao()), "Fade end 1e30, no range check: rims along the columns and on the ground.",
              halo.render_command()},
             {"halo_cured", ao_picture(halo_cured.ao()), "Fade end {radius}, the radius: the rim is gone.",
              halo_cured.render_command()});
book.show({"halo_error", ringed(rim_judge.signed_error(halo), rim, 1), "The signed error: the rims are all too dark. The ring is around that texel.",
           halo.probe_command(rim)});

// %% halo_text [markdown]
// It is texel ({halo_texel_x}, {halo_texel_y}), under pixel ({halo_x}, {halo_y}), and the map says {halo_ao}.

// %% halo_places
book.transcript(halo.terminal_transcript(on_rim, far_liar), "In the terminal: the guilty sample of the halo.");
book.transcript(halo.debugger_transcript(on_rim, far_liar), "In the debugger: the same sample.");
book.show({"halo_samples", halo.overlay(on_rim),
           "In the browser: all samples that occlude are on the column in front.", halo.probe_command(rim)});
book.draw("halo_section", halo.section(on_rim, far_liar, "The guilty sample of the halo"),
          "The cut: the eye's ray through q has met the column long before, at an r far to the left, outside of the drawing.");

// %% halo_reading [markdown]
// Here *dp* is honest: $r$ does lie above the plane of $p$. But *dz* is {halo_dz}, which is {halo_radii} times the radius. What is
// so far in front of $p$ is farther from it than any sample has looked, and yet its *weight* is 1: nothing fades it out. The
// weight comes from fade start and fade end, so the parameter is `fade_end`. X_Jun's 2 takes a part of the halo away; the
// radius, {radius}, takes all of it. In the lab, lower it until the row says "too far in front".

// %% halo_checked
const ExplainedSample cured_far = halo_cured.explanation(rim).samples[far_liar];
book.numbers({{"halo_verdict", cured_far.verdict}, {"halo_cured_ao", text(halo_cured.ao().at(rim.x, rim.y))}});
book.check("Sample {halo_sample} takes {halo_takes}, although the ray to its q meets nothing.",
           of_rim.samples[far_liar].contribution > 0 && rim_judge.is_free(of_rim, far_liar) && radii > 1);
book.check("With fade end {radius} its verdict is \"{halo_verdict}\", and the texel has {halo_cured_ao}.",
           cured_far.contribution == 0 && std::string(cured_far.verdict) == "too far in front" && halo_cured.ao().at(rim.x, rim.y) > 0.9f);
book.check("Of {rims} texels of open planes that were darker than 0.9, {rims_published} are left with fade end 2, and {rims_left} with {radius}.",
           rims_published.size() < rims.size() && rims_left.size() < rims.size() / 4);

// %% bands_title [markdown]
// ## Banding
//
// No single value of a band is very wrong; its border is. So on the third picture we look for *false borders*: two neighbours on one plane
// between which the map changes, and truth by less than a quarter of that. The guilty sample is the one that says one thing here
// and another thing there.

// %% bands_found
const ProbedView bands_cured(foot, {});
const RayJudge foot_judge(foot, bands, book.seed());
const std::vector<FalseBorder> borders = foot_judge.false_borders(bands, 0.1f), borders_cured = foot_judge.false_borders(bands_cured, 0.1f);
const std::vector<FalseBorder> alone = made_by_one(bands, borders), alone_cured = made_by_one(bands_cured, borders_cured);
const FalseBorder& highest = alone.at(0);
const PixelProbe at_border = bands.probe(highest.dark);
const Explanation beyond = bands.explanation(highest.light);
const ChangedSample changed = changed_most(at_border.ao.explanation, beyond);
name_numbers(book, "bands", at_border, changed.sample);
book.numbers({{"bands_share", percent_text(changed.share)},
              {"bands_next_ao", text(bands.ao().at(highest.light.x, highest.light.y))},
              {"bands_next_dz", text(beyond.samples[changed.sample].dz)},
              {"bands_next_takes", text(beyond.samples[changed.sample].contribution)},
              {"bands_next_verdict", beyond.samples[changed.sample].verdict}});
book.compare({"bands_again", ao_picture(bands.ao()), "No random turn: bands round the foot.", bands.render_command()},
             {"bands_cured", ao_picture(bands_cured.ao()), "Turned at random, texel by texel: grain, which the blur of chapter 08 removes.",
              bands_cured.render_command()});
book.show({"bands_error", ringed(foot_judge.signed_error(bands), highest.dark, kDifferenceScale),
           "The signed error has borders, too: none of them is in the scene. The ring is around the one that we follow.",
           bands.probe_command(highest.dark)});

// %% bands_text [markdown]
// The highest false border that a single sample makes lies between texel ({bands_texel_x}, {bands_texel_y}), under pixel ({bands_x}, {bands_y}), with
// {bands_ao} and a neighbour with {bands_next_ao}.

// %% bands_places
book.transcript(bands.terminal_transcript(at_border, changed.sample), "In the terminal: the sample that makes the border, on its dark side.");
book.transcript(bands.debugger_transcript(at_border, changed.sample), "In the debugger: the same sample.");
book.show({"bands_samples", bands.overlay(at_border), "In the browser. Ask for the neighbouring pixels there: the same samples, all moved by a pixel.",
           bands.probe_command(highest.dark)});
book.draw("bands_section", bands.section(at_border, changed.sample, "The sample that makes a border"),
          "The cut through that sample.");

// %% bands_reading [markdown]
// On this side of the border the sample has a dz of {bands_dz} and takes {bands_takes}; on the other side dz is
// {bands_next_dz}, and it takes {bands_next_takes} ("{bands_next_verdict}"). Every sample of every method has such an edge
// somewhere. It shows only because all texels ask in the same directions: then they all reach the edge along one line. The
// parameter is `random_vectors`.

// %% bands_checked
const double apart = mean_distance(at_border.ao.explanation, beyond);
const double apart_cured = mean_distance(bands_cured.explanation(highest.dark), bands_cured.explanation(highest.light));
const auto share_of = [](const auto& some, const auto& all) { return static_cast<double>(some.size()) / static_cast<double>(all.size()); };
const double lone = share_of(alone, borders), lone_cured = share_of(alone_cured, borders_cured);
book.number("apart_cured", apart_cured, 2);
book.numbers({{"borders", borders.size()}, {"lone", percent_text(lone)}, {"lone_cured", percent_text(lone_cured)}});
book.check("Sample {bands_sample} makes {bands_share} of all that changes across the border.", changed.share >= 0.9);
book.check("Both texels have the same fourteen vectors. With random turns, their vectors are {apart_cured} units apart on average.",
           apart < 1e-5 && apart_cured > 1000 * apart);
book.check("Of {borders} false borders above 0.1 in the banded map, a single sample makes {lone}. With random turns it is {lone_cured}: "
           "there, all samples change from texel to texel.", lone > lone_cured);

// %% exercises [markdown]
// ## Exercises
//
// 1. The first picture again, with `--param epsilon=0.5` beside `self_occlusion_test=false`. Which row of the probe changes its
//    verdict, and what has the picture lost?
// 2. Open the halo in the lab and set `fade_end` to 1. Is the rim gone? What does the probe say now?
// 3. `crevice render columns --ao hemisphere --param bias=0 --param self_occlusion=depth --only ao_raw` has acne, too. Probe a grey texel of
//    its floor. Which number of its samples is the wrong one?
// 4. A method without samples, such as `msvo` or `gtao`: what takes the place of the guilty sample?
//
// <details><summary>Answers</summary>
//
// 1. All samples say "nothing in front", for the floor rises by less than 0.5 within the radius. But the corners are white as
//    well: what stands nearer than 0.5 does not count either.
// 2. It is narrower: what stands between the radius and 1 unit in front still counts a little. The guilty sample of our texel says
//    "too far in front".
// 3. The number is again that of the distance in front: it is a rounding error and a part of a pixel, far smaller than the
//    published bias, and there is no dp that would ask whether it lies in the same plane.
// 4. The probe lists what the method adds up: volumes of `msvo`, slices of `gtao` with their two horizons. The one that takes most
//    has a horizon at a point r, and that point's dz and distance are read as here.
//
// </details>
//
// ## Where to go on
//
// Each artifact has its chapter: acne and halos 06, bands 07, blurs that leak 08, what the screen does not show 11. Every
// parameter that can be set wrong stands in `crevice params xjun`, and `crevice probe --help` has the passes before and after
// AO: why a triangle is not seen, which taps the blur took, what each light adds.

// %% end tags=["setup"]
}

const Chapter kChapter25("25", "guilty_sample", "From the picture to the guilty sample", guilty_sample);

}  // namespace
}  // namespace crevice
