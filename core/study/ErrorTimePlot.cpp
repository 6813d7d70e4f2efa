// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/ErrorTimePlot.h"

#include "core/study/PlotLabels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <span>

namespace toile::study {
namespace {

/// Told apart on white, also by most who see few colours. Black is the front's.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                             "#56b4e9", "#7b3294", "#8c510a", "#9a9a00", "#707070"};

/// Of the axes' frame in the smaller of both pictures, beside a key as wide as it mostly is [px].
constexpr Vec2 graphSize{520, 440};

/// As gnuplot reads it between single quotes.
std::string quoted(const std::string& text) {
    std::string doubled;
    for (const char c : text) doubled += c == '\'' ? "''" : std::string(1, c);
    return "'" + doubled + "'";
}

void appendData(std::string& text, const ErrorTimePlot& plot) {
    const auto out = std::back_inserter(text);
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        fmt::format_to(out, "$curve{} << EOD\n", i);
        for (const PlotCurve::Point& point : plot.curves[i].points)
            fmt::format_to(out, "{:.6g} {:.6g} {:.3g}\n", point.cost, point.error, point.label);
        fmt::format_to(out, "EOD\n");
    }
    fmt::format_to(out, "$front << EOD\n");
    for (const CostError& point : plot.front) fmt::format_to(out, "{:.6g} {:.6g}\n", point.cost, point.error);
    fmt::format_to(out, "EOD\n");
}

void appendCurves(std::string& text, const ErrorTimePlot& plot) {
    const auto out = std::back_inserter(text);
    for (int i = 0; const PlotCurve& curve : plot.curves) {
        const auto colour = static_cast<std::size_t>(curve.colour >= 0 ? curve.colour : i);
        fmt::format_to(
            out,
            "  $curve{} using 1:2 with linespoints linecolor rgb '{}' pointtype {} dashtype {} linewidth 1.5 "
            "title {}, \\\n",
            i, colours[colour % colours.size()], colour + 4, curve.dashed ? 2 : 1, quoted(curve.title));
        ++i;
    }
}

struct AxisRange {
    double low = 0, high = 0;

    [[nodiscard]] double shareOf(double value) const { return std::log(value / low) / std::log(high / low); }
};

/// From a little below the least to a little above the largest.
AxisRange rangeOf(const ErrorTimePlot& plot, double PlotCurve::Point::*coordinate, double low) {
    constexpr double beyond = 1.25;
    double high = low;
    for (const PlotCurve& curve : plot.curves)
        for (const PlotCurve::Point& point : curve.points) {
            low = low > 0 ? std::min(low, point.*coordinate) : point.*coordinate;
            high = std::max(high, point.*coordinate);
        }
    return {low / beyond, high * beyond};
}

/// 1, 2, 5 a decade, and more where the axis is shorter than one.
void appendNarrowAxis(std::string& text, char axis, const AxisRange& range) {
    static constexpr std::array coarse{1.0, 2.0, 5.0};
    static constexpr std::array fine{1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
    const std::span<const double> digits = range.high < 10 * range.low ? std::span<const double>(fine) : coarse;
    std::string tics;
    for (int decade = -3; decade <= 4; ++decade)
        for (const double digit : digits)
            tics += fmt::format("{}{:g}", tics.empty() ? "" : ",", digit * std::pow(10, decade));
    text += fmt::format("set format {0} '%g'\nset {0}tics ({1})\nset {0}range [{2:.4g}:{3:.4g}]\n", axis, tics,
                        range.low, range.high);
}

/// The label of each point, where it covers neither a point nor another label.
void appendLabels(std::string& text, const ErrorTimePlot& plot, const AxisRange& costs, const AxisRange& errors) {
    std::vector<PlotCurve::Point> points;
    for (const PlotCurve& curve : plot.curves) points.insert(points.end(), curve.points.begin(), curve.points.end());
    std::erase_if(points,
                  [](const PlotCurve::Point& point) { return point.cost <= 0 || point.error <= 0; }); // no place
    std::vector<PointLabel> labels;
    for (const PlotCurve::Point& point : points)
        labels.push_back({{graphSize.x * costs.shareOf(point.cost), graphSize.y * errors.shareOf(point.error)},
                          fmt::format("{:.3g}", point.label)});
    const auto places = placedLabels(labels);
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (places[i])
            text += fmt::format("set label '{}' at {:.6g},{:.6g} center offset graph {:.4f},{:.4f} font ',9' front\n",
                                labels[i].text, points[i].cost, points[i].error, places[i]->x / graphSize.x,
                                places[i]->y / graphSize.y);
}

void appendNarrowAxes(std::string& text, const ErrorTimePlot& plot) {
    const AxisRange costs = rangeOf(plot, &PlotCurve::Point::cost, 0),
                    errors = rangeOf(plot, &PlotCurve::Point::error, plot.band);
    appendNarrowAxis(text, 'x', costs);
    appendNarrowAxis(text, 'y', errors);
    appendLabels(text, plot, costs, errors);
}

} // namespace

std::string gnuplotScript(const ErrorTimePlot& plot, const std::string& file) {
    std::string text;
    const auto out = std::back_inserter(text);
    appendData(text, plot);
    fmt::format_to(
        out,
        "set logscale xy\nset format x '10^{{%L}}'\nset format y '10^{{%L}}'\nset grid\nset key outside right\n"
        "set title {} noenhanced\nset xlabel {}\nset ylabel {}\n",
        quoted(plot.title), quoted(plot.costLabel), quoted(plot.errorLabel));
    fmt::format_to(out,
                   "set object rectangle from graph 0, graph 0 to graph 1, first {:.6g} fillcolor rgb '#dddddd' "
                   "fillstyle solid noborder behind\n",
                   plot.band);
    if (plot.narrow) appendNarrowAxes(text, plot);
    const std::array<std::pair<const char*, const char*>, 2> formats{
        {{"svg size 900,560 dynamic background rgb 'white' font 'DejaVu Sans,13'", "svg"},
         {"pngcairo size 1200,760 font 'DejaVu Sans,13'", "png"}}};
    for (const auto& [terminal, extension] : formats) {
        fmt::format_to(out, "set terminal {}\nset output '{}.{}'\nplot \\\n", terminal, file, extension);
        appendCurves(text, plot);
        fmt::format_to(out, "  $front using 1:2 with {} linecolor 'black' title 'front'\n",
                       plot.front.size() > 1 ? "lines dashtype 2 linewidth 2" : "points pointtype 6 pointsize 2.5");
    }
    return text;
}

} // namespace toile::study
