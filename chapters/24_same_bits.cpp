// %% setup tags=["setup"]
// Source: IEEE 754-2019, clauses 4.3 and 5.4 (what is rounded how); Goldberg 1991, "What every computer scientist should
// know about floating-point arithmetic"; the machines' own manuals for estimates and conversions.
// Run: crevice chapter 24
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>

#include "chapters/frame/frame.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/frame_hashes.h"
#include "chapters/props/lost_bits.h"
#include "chapters/props/maps_apart.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

constexpr int kThreads[] = {1, 2, 7}, kTiles_px[] = {16, 32, 64};

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void same_bits(Notebook& book) {

// %% question [markdown]
// # The same bits
//
// Here is the AO of a wall of bumps. Three programs have computed it from one and the same source text, and to the eye the
// three maps are one. The first program is this lab. In the second, the compiler was allowed to use an instruction that
// multiplies and adds in one go; the third adds up four samples at a time. Look at the two pictures below: they show in how
// many texels what the fourteen samples take together is *not* the same number.

// %% maps tags=["setup"]
const SwitchedView view(book, "noise_wall");
const AoInputs inputs = view.ao().inputs;
const LunaKernel kernel(inputs, kXjunSettings);
const RandomMap random = random_map(kXjunSettings.seed);
const OcclusionMaps in_order = maps_with(kernel, random, {});
const Image<float>& plain = in_order.ao;
const MapsApart fused = maps_apart(in_order, maps_with(kernel, random, {.dot = fused_dot})),
                otherwise = maps_apart(in_order, maps_with(kernel, random, {.dot = otherwise_fused_dot})),
                in_fours = maps_apart(in_order, maps_with(kernel, random, {.sum = sum_of_four}));

// %% start
book.show("ao", ao_picture(plain), "The AO of all three.");
book.show_row({{"apart_fused", apart_picture(fused),
                "The first and the second program: by how many steps of a float their sums differ. Black "
                "is 0, white 4 and more."},
               {"apart_in_fours", apart_picture(in_fours), "The first and the third."}});

// %% why [markdown]
// Does it matter? Whoever changes a program wants to know whether the picture is still the same. If the answer is "up to
// 0.01 or so", small mistakes hide below that. If equal means *equal bits*, the test is one comparison of hashes, and it
// holds on the laptop of the student, on the server that tests, in the browser. Every picture of this book is meant to be
// the same on all of them.

// %% idea [markdown]
// ## The idea
//
// **Each operation has exactly one right answer, so the same operations in the same order give the same bits.**
//
// The standard for floating-point numbers, IEEE 754, demands of $+$, $-$, $\times$, $\div$ and $\sqrt{\ }$ that the result
// be the exact one, *rounded* to the nearest number that the format can hold, and of two equally near ones the one whose
// last bit is 0. There is nothing left to choose, and every processor that this lab runs on obeys. What differs between two
// machines, two compilers or two numbers of threads is never the operation; it is *which* operations are done, and in which
// order.

// %% three_ways_of_one
const ThreeWays ways = three_ways(kernel);
book.numbers({{"v", exact_text(ways.v.x) + ", " + exact_text(ways.v.y) + ", " + exact_text(ways.v.z)},
              {"exact", significant_text(ways.exact, 12)}, {"rounded", bits_of(ways.rounded)}, {"fused", bits_of(ways.fused)},
              {"otherwise", bits_of(ways.otherwise_fused)}});
book.draw("number_line", number_line(ways),
          "The ticks are floats, one step apart. The exact square of the length of p = ({v}) is {exact}, between two of them. "
          "Rounding every product and every sum leads to the bits {rounded}; leaving out one rounding or another leads to "
          "{fused} and {otherwise}. None of the three is a mistake.");

// %% derivation [markdown]
// ## Why the order matters
//
// A float has 24 significant bits. Write $\mathrm{fl}(a)$ for the nearest float; it is off by at most half a step,
//
// $$ \mathrm{fl}(a) = a\,(1 + \delta), \qquad |\delta| \le u = 2^{-24} $$
//
// The line `x*x + y*y + z*z` means, in C++, from left to right:
//
// $$ s = \mathrm{fl}\big(\mathrm{fl}(\mathrm{fl}(x^2) + \mathrm{fl}(y^2)) + \mathrm{fl}(z^2)\big) $$
//
// Five roundings, all of them fixed. A *fused multiply-add* computes $\mathrm{fl}(ab + c)$ with one rounding where there
// were two. It is faster and usually nearer to the truth, but other bits:
// $\mathrm{fl}(z^2 + \mathrm{fl}(y^2 + \mathrm{fl}(x^2)))$ has three roundings left, and $x$ and $y$ may as well change
// places.
//
// And addition is not associative. Take $a = 1$, $b = c = u$: then $\mathrm{fl}(a + b)$ is the tie between 1 and its
// neighbour and goes to 1, so $(a + b) + c = 1$. But $b + c = 2u$ is a whole step, so $a + (b + c) = 1 + 2u$.

// %% rules [markdown]
// ## How the same bits are made
//
// From this follow the rules that every kernel of this lab keeps:
//
// 1. Only $+ - \times \div \sqrt{\ }$. What else is needed (powers, sines) is a polynomial of our own, out of these.
// 2. The compiler may not fuse: `-ffp-contract=off` stands in the build for every file, the tests included. It may not
//    reorder either; without `-ffast-math` the language forbids it.
// 3. Several pixels at a time, never several samples of one: each *lane* of a register does what a single float would. No
//    sum ever runs across lanes.
// 4. A thread writes its own pixels and nothing else. What is summed over a picture is summed row by row, in order.
// 5. Random numbers come from an integer hash of pixel and sample, not from a generator that remembers who asked before.
//
// A kernel is written once for a type `F`, and this is how it is run. `Lanes<float>` is one pixel at a time, to step
// through in a debugger; otherwise `F` is as wide as the register:

// %% code_of_runs tags=["setup"]
book.listing("rasterizer/base/run.h", "run_kernel", "The same text for every width.");
book.listing(
    "rasterizer/lanes/isa.h", "call_for_isa",
    "Which instructions the compiler may use is decided around the kernel, so that no kernel knows.");
book.listing(
    "rasterizer/lanes/approx_math.h", "exp2_of",
    "The library's own power of two: nothing but rule 1. Its error is stated, and the same everywhere.");

// %% every_way_text [markdown]
// ## The same frame in every way
//
// So let us draw one frame in every way that this machine knows: each form of the kernels, with one, two and seven threads,
// with tiles of 16, 32 and 64 pixels.

// %% every_way
FrameRequest request = xjun_request(book.size());
const Scene columns = columns_scene();
const std::string first = hashes_of(render_frame(columns, columns.camera, request));
std::vector<std::vector<std::string>> form_rows;
int runs = 0, same = 0;
for (const KernelForm& form : forms_of_this_machine()) {
    request.run = form.run;
    std::string blurred;
    for (const int threads : kThreads) {
        for (const int tile_px : kTiles_px) {
            request.run.threads = threads;
            request.run.tile_size = tile_px;
            const Frame frame = render_frame(columns, columns.camera, request);
            blurred = content_hash(frame.ao_blurred);
            ++runs;
            same += hashes_of(frame) == first ? 1 : 0;
        }
    }
    form_rows.push_back({form.name, std::to_string(std::size(kThreads) * std::size(kTiles_px)), blurred});
}
book.number("runs", std::to_string(runs));
book.table({"form of the kernels", "runs", "hash of the blurred AO"}, form_rows);
book.check("All {runs} runs agree in every bit of all six buffers.", same == runs);
book.check("The estimator written down once more in this chapter, with plain arithmetic, has the library's bits too.",
           content_hash(plain) == content_hash(luna_occlusion(inputs, kXjunSettings, {}).ao));

// %% other_machines_text [markdown]
// One machine cannot show what another does. But hashes can be written down. The lab's repository holds a file of them,
// `tests/golden/hashes.txt`. GCC on x86-64 wrote it, and the tests of every build are held to it: by GCC and by Clang,
// without and with optimisation, for x86-64, for 64-bit ARM and for WebAssembly. Here is what it says of the columns, 160
// pixels wide, and what *your* machine has just computed:

// %% other_machines
const Scene recorded_scene = find_builtin_scene("columns")->make(SceneDetail::surfaces);
const Frame small = render_frame(recorded_scene, recorded_scene.camera, xjun_request({160, 90}));
std::vector<std::vector<std::string>> recorded_rows;
bool as_recorded = true;
for (const char* buffer : {"normal", "view_depth", "ndc_depth", "ao_raw", "ao_blurred"}) {
    recorded_rows.push_back({buffer, recorded_hash(buffer), hash_named(small, buffer)});
    as_recorded = as_recorded && recorded_hash(buffer) == hash_named(small, buffer);
}
book.table({"buffer", "on record", "computed here"}, recorded_rows);
book.check("This machine computes what is on record, bit for bit.", as_recorded);

// %% machines [markdown]
// That they agree is no matter of course. This is where the three differ:
//
// | | x86-64 | 64-bit ARM | WebAssembly |
// |---|---|---|---|
// | lanes of a float register | 4, with AVX2 8, with AVX-512 16 | 4 | 4 |
// | fused multiply-add | from 2013 on, if asked for | always there, used by default | none in the base |
// | estimate of $1/\sqrt{a}$ | 12 bits, by maker | 8 bits | none |
// | float to int, too large | smallest int | largest int | trap, or largest int |
// | NaN to int | smallest int | 0 | trap, or 0 |
// | the NaN of 0/0 | negative | positive | either |

// %% contraction_text [markdown]
// ## Five ways to lose them
//
// Each of the following is a naive version of something that the lab does otherwise. They stand in
// `chapters/props/lost_bits.cpp`, and only this chapter uses them.
//
// **1. The compiler fuses.** On 64-bit ARM every processor has the instruction, and GCC uses it unless it is told not to.
// The same source then has other bits there than on x86-64, and two compilers may fuse two different products. *The cure*
// is one word in the build, `-ffp-contract=off`.

// %% contraction
book.listing("chapters/props/lost_bits.cpp", "fused_dot",
             "The same sum of products, with one rounding each where the kernel has two.");
book.table(kApartColumns, {apart_row("fused, from left to right", fused),
                           apart_row("fused, x and y exchanged", otherwise)});
book.numbers({{"fused_texels", fused.ao.texels}, {"otherwise_texels", otherwise.ao.texels}});
book.check("One way of fusing changes {fused_texels} texels of the AO map, the other {otherwise_texels}.",
           fused.ao.texels > 0 && otherwise.ao.texels > 0);
const float product = ways.v.x * ways.v.y, rest = std::fma(ways.v.x, ways.v.y, -product);
book.number("rest", significant_text(static_cast<double>(rest), 3));
book.check("Fusing may even break an identity: with the x and y from above, xy - xy is not 0 but {rest}, because only one of "
           "the two products was rounded.",
           rest != 0);

// %% reassociation_text [markdown]
// **2. The sum is taken in another order.** Four lanes that each add every fourth sample, and are added up at the end, are
// faster than one long chain. So is what `-ffast-math` makes of the plain loop, and every width of register makes another
// sum. *The cure*: lanes hold pixels, never samples.

// %% reassociation
book.listing("chapters/props/lost_bits.cpp", "sum_of_four", "Four lanes, each with every fourth sample.");
const OcclusionMaps again = maps_with(kernel, random, {.sum = sum_in_order});
book.table(kApartColumns, {apart_row("one sample after the other", maps_apart(in_order, again)),
                           apart_row("four partial sums", in_fours)});
book.number("fours_texels", std::to_string(in_fours.ao.texels));
book.check("Four partial sums change {fours_texels} texels of the AO map.", in_fours.ao.texels > 0);

// %% estimates_text [markdown]
// **3. An estimate, or somebody else's function.** Processors have an instruction for about $1/\sqrt{a}$, and the manual
// says how far it may be off, not which number it gives. Two makers chose two. A step of Newton's,
// $x' = x\,(1.5 - 0.5\,a\,x^2)$, makes both good, but not equal. The mathematical library is the same story: `pow` promises
// a small error, not a result, and each version, on some machines each processor, has its own. *The cure*: a division by a
// square root, which the standard defines, and polynomials of our own.

// %% estimates
book.listing("chapters/props/lost_bits.cpp", "by_rounded_estimate",
             "One maker's estimate: the right value, rounded to twelve bits; then the step of Newton's.");
const OcclusionMaps by_a = maps_with(kernel, random, {.divide = by_rounded_estimate}),
                    by_b = maps_with(kernel, random, {.divide = by_cut_estimate}),
                    by_product = maps_with(kernel, random, {.power = by_products});
const MapsApart maker_a = maps_apart(in_order, by_a), maker_b = maps_apart(in_order, by_b),
                makers = maps_apart(by_a, by_b), products = maps_apart(in_order, by_product);
book.table(kApartColumns, {apart_row("estimate of twelve bits, rounded, refined", maker_a),
                           apart_row("estimate of twelve bits, cut off, refined", maker_b),
                           apart_row("one estimate against the other", makers),
                           apart_row("another fourth power", products)});
book.show_row({{"apart_a", apart_picture(maker_a),
                "One maker's estimate, refined, against the division. White is 4 steps and more."},
               {"apart_b", apart_picture(maker_b), "Another maker's."}});
book.numbers({{"a_texels", maker_a.ao.texels}, {"b_texels", maker_b.ao.texels}, {"makers_texels", makers.ao.texels},
              {"p_texels", products.ao.texels}});
book.check("One estimate changes {a_texels} texels and the other {b_texels}; between the two makers {makers_texels} differ. "
           "Another fourth power changes {p_texels}.",
           maker_a.ao.texels > 0 && maker_b.ao.texels > 0 && makers.ao.texels > 0 && products.ao.texels > 0);

// %% threads_text [markdown]
// **4. The order of threads.** Eight threads compute the rows of a map, and each adds the sum of its row to a common total
// as soon as it is ready. Which is ready first is another in every run. Here the orders are drawn by lot, so that this page
// stays the same; real threads do worse. If the total then sets the exposure of the picture, every pixel of it changes.
// *The cure*: each thread keeps its own, and one adds them up in the order of the rows.

// %% threads
book.listing("chapters/props/lost_bits.cpp", "sum_of_rows", "A common total.");
constexpr std::uint32_t kOrders = 100;
std::set<std::string> sums;
std::vector<std::vector<std::string>> order_rows;
for (std::uint32_t which = 0; which < kOrders; ++which) {
    const float sum = sum_of_rows(plain, order_of_threads(plain.size.height, book.seed(), which));
    sums.insert(bits_of(sum));
    if (which < 4)
        order_rows.push_back({which == 0 ? "from top to bottom" : "by lot, no. " + std::to_string(which),
                              exact_text(sum), bits_of(sum)});
}
book.numbers({{"orders", kOrders}, {"sums", sums.size()}});
book.table({"order of the rows", "sum of the map", "its bits"}, order_rows);
book.check("{orders} orders of the same rows have {sums} different sums.", sums.size() > 1);

// %% conversions_text [markdown]
// **5. What the language leaves open.** Converting a float to an int is undefined in C++ where the int cannot hold it, and
// machines differ. The picture shows view depth as a grey: scaled, converted, and then clamped to 0..255. The sky's depth
// is infinite. *The cure*: clamp first, then convert, and write comparisons so that a NaN takes the safe side.

// %% conversions
book.listing("chapters/props/lost_bits.cpp", "as_bytes", "Converted first, clamped afterwards.");
const SwitchedView whole(book, "columns");
const Image<float> depth = whole.ao().gbuffer.view_depth;
const float farthest = buffer_statistics(depth).max;
const Image<float> of_x86 = as_bytes(depth, farthest, to_int_of_x86),
                   of_arm = as_bytes(depth, farthest, to_int_of_arm);
const BitsApart converted = bits_apart(of_x86, of_arm);
book.compare({"bytes_x86", grey_picture(of_x86, 0, 255),
              "x86-64: infinity becomes the smallest int, the sky black."},
             {"bytes_arm", grey_picture(of_arm, 0, 255),
              "64-bit ARM: it becomes the largest int, the sky white."});
book.numbers({{"sky", converted.texels}, {"nan_x86", to_int_of_x86(std::nanf(""))}, {"nan_arm", to_int_of_arm(std::nanf(""))}});
book.check("The two pictures differ in {sky} pixels, all of the sky. A NaN becomes {nan_x86} on one machine and {nan_arm} on "
           "the other.",
           converted.texels > 0);

// %% padding_text [markdown]
// The same goes for memory that nobody has written. Rows of an image begin at whole groups of eight pixels, and behind a
// row of another length a few values are left over. Whoever takes a sum or a hash over *all* of the memory takes those with
// it. Here is one map twice, with other leftovers:

// %% padding
const Image<float> zeros = narrow(plain, 0), ones = narrow(plain, 1);
book.table({"behind the rows", "hash of all the memory", "hash of the pixels"},
           {{"0", std::to_string(memory_hash(zeros)), content_hash(zeros)},
            {"1", std::to_string(memory_hash(ones)), content_hash(ones)}});
book.check("The hash of the memory tells the two maps apart, the hash of the pixels does not: they are equal.",
           memory_hash(zeros) != memory_hash(ones) && content_hash(zeros) == content_hash(ones));
book.listing_part("ssao/methods/luna_occlusion.h", "cell_at", "x = min_of", "floor_to_int",
                  "The cure in the kernel: a position far off the screen, or a NaN, is clamped while it is still a float.");

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice render columns --only ao_blurred --out a`, then the same with `--lanes 1 --threads 1 --out b`, and
//    `crevice compare a/ao_blurred.npy b/ao_blurred.npy`. What does it say?
// 2. Is $ab + ba$ always equal to $2ab$ in floats? And when it is fused?
// 3. Remove `-ffp-contract=off` from `CMakeLists.txt` and build. On an x86-64 machine without AVX-512 the tests still pass.
//    Why, and which further flag makes them fail? What of a machine with AVX-512?
// 4. Your function sums a million floats on all cores. Give two ways to make the result independent of the number of
//    threads.
// 5. (Open) A GPU promises IEEE rounding for $+$, $-$ and $\times$, but not for division and square root. How much of the
//    estimator of chapter 06 could give these bits on a GPU, and what would you put in place of the rest?
//
// <details><summary>Answers</summary>
//
// 1. That they are equal, bit for bit: the hashes are the same.
// 2. Yes: both products round to the same float, and doubling it is exact. Fused, $\mathrm{fl}(ab + \mathrm{fl}(ba))$ has
//    one product unrounded, and may differ from $2\,\mathrm{fl}(ab)$ in the last bit.
// 3. Neither the instructions that every x86-64 machine has nor AVX2 by itself know a fused multiply-add: nothing can be
//    fused. With `-mfma`, or `-march=native` on a newer machine, the flag is what keeps the bits. AVX-512 brings one along,
//    and its form of the kernels would be fused without the flag.
// 4. Cut the input into blocks of a fixed size, whatever the number of threads, sum each in order, and add up the block
//    sums in order. Or sum integers (fixed point), whose addition is associative.
// 5. All products and sums. A division can be made from an estimate and integer arithmetic, or by two Newton steps and a
//    last correction with exact residuals; that is what the compilers' own software division does.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun and Luna* (tutorials for Direct3D 11 and 12) take the lengths of the fourteen vectors and the random map from `rand()`, whose numbers are another
//   for each compiler's library: no two readers see the same grain. Here an integer hash makes them.
// - *X_Jun and Luna* normalise with HLSL's `normalize`, which the shader compiler may turn into an estimated reciprocal
//   root.
//
// </details>
//
// ## Where to go on
//
// Equal bits say that a change has changed nothing. They do not say that the bits are right: chapter 22 asks what the
// rounding costs where scenes are extreme, and chapter 21 how far the picture is from the truth.

// %% end tags=["setup"]
}

const Chapter kChapter24("24", "same_bits", "The same bits", same_bits);

}  // namespace
}  // namespace crevice
