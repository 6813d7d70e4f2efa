// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/StiffnessMap.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace toile::study::stability {
namespace {

constexpr double bestShown = -5, worstShown = 0; // decades of the error

std::vector<double> valuesOf(const std::vector<MapCell>& cells, double MapCell::*field) {
    std::vector<double> values;
    for (const MapCell& cell : cells) values.push_back(cell.*field);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t placeOf(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
}

std::string stepText(double step) {
    return step > 1.0 / 1000 && step < 0.1 ? fmt::format("1/{:.0f}", 1 / step) : fmt::format("{:g}", step);
}

std::string ticsOf(const std::vector<double>& values, const auto& textOf) {
    std::string tics;
    for (std::size_t i = 0; i < values.size(); ++i)
        tics += fmt::format("{}'{}' {}", i == 0 ? "" : ", ", textOf(values[i]), i);
    return "(" + tics + ")";
}

/// What is written into a cell: why it has no colour, or how much softer the cloth was.
std::string markOf(const MapCell& cell) {
    if (cell.run.refused) return "–";
    if (!cell.bounded) return "×";
    return cell.softened < 0.99 ? fmt::format("{:.0e}", cell.softened) : "";
}

} // namespace

std::string mapScript(const std::vector<MapCell>& cells) {
    const auto steps = valuesOf(cells, &MapCell::step), stiffnesses = valuesOf(cells, &MapCell::stiffness);
    std::string text;
    const auto out = std::back_inserter(text);
    const auto methods = mapMethods();
    const auto block = [&](const std::string& name, const auto& isIn, const auto& columnOf) {
        fmt::format_to(out, "${} << EOD\n", name);
        bool any = false;
        for (const MapCell& cell : cells)
            if (isIn(cell)) {
                const auto x = static_cast<double>(placeOf(steps, cell.step)),
                           y = static_cast<double>(placeOf(stiffnesses, cell.stiffness));
                fmt::format_to(out, "{} {} {} {} {} {} {}\n", x, y, x - 0.5, x + 0.5, y - 0.5, y + 0.5, columnOf(cell));
                any = true;
            }
        if (!any) text += "-9 -9 -9 -9 -9 -9 0\n"; // outside: gnuplot wants a line
        text += "EOD\n";
    };
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const auto isOf = [&](const MapCell& cell) { return cell.method == methods[m].name; };
        const auto decade = [](const MapCell& cell) {
            return std::clamp(std::log10(std::max(cell.error, 1e-30)), bestShown, worstShown);
        };
        block(
            fmt::format("error{}", m), [&](const MapCell& c) { return isOf(c) && c.bounded && std::isfinite(c.error); },
            decade);
        block(
            fmt::format("soft{}", m), [&](const MapCell& c) { return isOf(c) && c.bounded && c.softened < 0.99; },
            [](const MapCell&) { return 0; });
        block(
            fmt::format("mark{}", m), [&](const MapCell& c) { return isOf(c) && !markOf(c).empty(); },
            [](const MapCell& c) { return "\"" + markOf(c) + "\""; });
    }
    const std::size_t height = 2 * (120 + 26 * std::max<std::size_t>(stiffnesses.size(), 6));
    const std::string settings = fmt::format(
        "set palette defined (-5 '#2c7fb8', -3 '#7fcdbb', -2 '#edf8b1', -1 '#fdae61', 0 '#b30000')\n"
        "set cbrange [{}:{}]\nset cblabel 'decades of the error'\nunset key\nset xrange [-0.5:{}]\n"
        "set yrange [-0.5:{}]\nset xtics out nomirror {} rotate by 45 right\nset ytics out nomirror {}\nset "
        "xlabel 'step s'\n"
        "set ylabel 'stiffness N/m'\nunset colorbox\n",
        bestShown, worstShown, static_cast<double>(steps.size()) - 0.5, static_cast<double>(stiffnesses.size()) - 0.5,
        ticsOf(steps, stepText), ticsOf(stiffnesses, [](double k) { return fmt::format("{:.0e}", k); }));
    for (const auto& [terminal, extension] :
         {std::pair{"svg size 1300,{} dynamic background rgb 'white' font 'DejaVu Sans,12'", "svg"},
          std::pair{"pngcairo size 1300,{} font 'DejaVu Sans,12'", "png"}}) {
        fmt::format_to(out,
                       "set terminal {}\nset output 'stiffness-map.{}'\n"
                       "set multiplot layout 2,3 title 'error of the falling flap over its way, by stiffness and step; "
                       "– refused, × energy grows'\n{}",
                       fmt::format(fmt::runtime(terminal), height), extension, settings);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            fmt::format_to(out, "set title '{}'\n{}", methods[m].name, m + 1 == methods.size() ? "set colorbox\n" : "");
            fmt::format_to(
                out,
                "plot $error{0} using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid noborder linecolor palette, \\\n"
                "  $soft{0} using 1:2:3:4:5:6 with boxxyerror fillstyle transparent pattern 4 noborder linecolor "
                "rgb '#555555', \\\n  $mark{0} using 1:2:7 with labels font ',9'\n",
                m);
        }
        text += "unset multiplot\n";
    }
    return text;
}

} // namespace toile::study::stability
