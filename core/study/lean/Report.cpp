// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/lean/Report.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace toile::study::lean {
namespace {

std::string differenceText(const Row& row) {
    if (!row.difference) return "";
    return *row.difference == 0 ? "none" : fmt::format("{:.2g}", *row.difference);
}

const char* aboutInstructions(const std::vector<FeatureResult>& results) {
    const bool counted = std::ranges::any_of(results, [](const FeatureResult& result) {
        return std::ranges::any_of(result.rows, [](const Row& row) { return row.taken.instructions.has_value(); });
    });
    return counted ? "Instructions are those of a frame step, counted by valgrind."
                   : "Instructions were not counted; --count does, where valgrind is installed.";
}

} // namespace

std::string summaryOf(const std::vector<FeatureResult>& results) {
    std::size_t rows = 0, passed = 0;
    std::vector<std::string> failing;
    for (const FeatureResult& result : results) {
        rows += result.rows.size();
        passed += static_cast<std::size_t>(
            std::ranges::count_if(result.rows, [](const Row& row) { return row.why.empty(); }));
        if (!passes(result)) failing.push_back(result.name);
    }
    std::string text = fmt::format("{} of {} rows pass.", passed, rows);
    return failing.empty() ? text : text + fmt::format(" Failing: {}.", fmt::join(failing, ", "));
}

std::string leanText(const std::vector<FeatureResult>& results, const Circumstances& circumstances) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out,
        "# What parts of a step cost, and that they cost nothing where they are not needed\n\n`{}`, {}, {}. One "
        "*calibration*, a loop over a million spring forces, takes {:.3g} ms.\n\n**{}**\n\n"
        "*absent*: the scene does not ask for the part; *unused*: it does, and the plan sees that it is of no use. In "
        "both the part is not in the plan and holds no byte, and an unused one leaves stages, allocations and "
        "positions "
        "as they are without it, bit by bit. *forced*: the part is there and has nothing to do; positions may differ "
        "by "
        "1e-12 m. *in use*: positions are others. Blocks and bytes are what operator new was asked for: to build the "
        "simulation, of which a forced one makes its plan twice, and for one frame step. CPU time is that of a frame "
        "step, the least and the median of repetitions "
        "that take turns. Difference: the largest of a node to the variant it is compared with. {}\n\n"
        "| feature | | scene | particles | stages | part B | blocks to build | KiB | blocks a step | 1000 instructions "
        "| "
        "CPU ms | median | difference m | verdict |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        circumstances.command, circumstances.program, circumstances.processor, 1e3 * circumstances.calibration,
        summaryOf(results), aboutInstructions(results));
    std::size_t rows = 0, noisy = 0;
    for (const FeatureResult& result : results)
        for (const Row& row : result.rows) {
            const Taken& taken = row.taken;
            ++rows;
            noisy += taken.frame.noisy;
            fmt::format_to(out, "| {} | {} | {} | {} | {} | {} | {} | {} | {:.4g} | {} | {:.3g} | {:.3g} | {} | {} |\n",
                           result.name, nameOf(row.role), row.what, taken.particles, fmt::join(taken.stages, ", "),
                           taken.partBytes, taken.building.blocks, taken.building.bytes / 1024, taken.blocksPerFrame(),
                           taken.instructions ? fmt::format("{:.0f}", *taken.instructions / 1000) : "",
                           1e3 * taken.frame.least, 1e3 * taken.frame.median, differenceText(row),
                           row.why.empty() ? "PASS" : "FAIL: " + row.why);
        }
    if (noisy > 0) text += '\n' + tooNoisy(noisy, rows) + '\n';
    return text;
}

} // namespace toile::study::lean
