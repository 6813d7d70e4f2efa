// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/CheckpointFile.h"

#include "core/base/AtomicFile.h"
#include "core/base/RegularFile.h"
#include "core/io/JsonNode.h"

#include <fmt/format.h>
#include <limits>

namespace toile::io {
namespace {

using simulation::Checkpoint;

constexpr int version = 1;
constexpr std::uint64_t largestCheckpoint = std::uint64_t{1} << 30; ///< [bytes]; 100 000 particles have some 12 million

constexpr double longest = 1e9;  ///< [s], some 30 years: still a frame step later than itself
constexpr double farthest = 1e6; ///< of any coordinate [m], and fastest [m/s]
constexpr double largest = std::numeric_limits<double>::max();

template <typename Number>
Json numbersOf(const std::vector<Number>& values) {
    Json::Array numbers;
    for (const Number value : values) numbers.emplace_back(static_cast<double>(value));
    return numbers;
}

Json vectorsOf(const std::vector<Vec3>& vectors) {
    Json::Array numbers;
    for (const Vec3& v : vectors)
        for (int axis = 0; axis < 3; ++axis) numbers.emplace_back(v[axis]);
    return numbers;
}

double numberFrom(const JsonNode& node, double low, double high = largest) {
    const double value = node.number(low);
    if (value >= low && value <= high) return value;
    node.refuse(high < largest ? fmt::format("Expected a number from {:g} to {:g}, but found {:g}.", low, high, value)
                               : fmt::format("Expected a number that is not below {:g}, but found {:g}.", low, value));
    return low;
}

/// A time at which something began; any negative one says that it has not.
double startFrom(const JsonNode& node) {
    return numberFrom(node, std::numeric_limits<double>::lowest(), longest);
}

std::vector<double> numbersOf(const JsonNode& node, double low = -largest, double high = largest) {
    std::vector<double> numbers;
    for (const JsonNode& item : node.items()) numbers.push_back(numberFrom(item, low, high));
    return numbers;
}

std::vector<Vec3> vectorsOf(const JsonNode& node) {
    const std::vector<double> numbers = numbersOf(node, -farthest, farthest);
    if (numbers.size() % 3 != 0) node.refuse("Expected three numbers for each place.");
    std::vector<Vec3> vectors;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        vectors.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return vectors;
}

Checkpoint::Seam seamOf(JsonNode& node) {
    return {.merged = node.required("merged").truth(),
            .initialGap = numberFrom(node.required("initialGap"), 0),
            .gapAtMerge = numberFrom(node.required("gapAtMerge"), 0),
            .start = startFrom(node.required("start")),
            .gaps = numbersOf(node.required("gaps"))};
}

Json jsonOf(const Checkpoint::Seam& seam) {
    Json json;
    json.set("merged", seam.merged).set("initialGap", seam.initialGap).set("gapAtMerge", seam.gapAtMerge);
    json.set("start", seam.start).set("gaps", numbersOf(seam.gaps));
    return json;
}

Checkpoint::Tack tackOf(JsonNode& node) {
    return {.closed = node.required("closed").truth(),
            .initialGap = numberFrom(node.required("initialGap"), 0),
            .start = startFrom(node.required("start")),
            .startGap = numberFrom(node.required("startGap"), 0)};
}

Json jsonOf(const Checkpoint::Tack& tack) {
    Json json;
    json.set("closed", tack.closed).set("initialGap", tack.initialGap);
    return json.set("start", tack.start).set("startGap", tack.startGap);
}

Json jsonOf(const dynamics::ContactMemory& contact) {
    Json json;
    json.set("forces", numbersOf(contact.forces)).set("takenBack", numbersOf(contact.takenBack));
    return json.set("anchors", vectorsOf(contact.anchors));
}

dynamics::ContactMemory contactOf(JsonNode& node) {
    return {.forces = numbersOf(node.required("forces"), 0),
            .takenBack = numbersOf(node.required("takenBack"), 0),
            .anchors = vectorsOf(node.required("anchors"))};
}

} // namespace

Result<void> writeCheckpoint(const Checkpoint& point, const std::string& path) {
    Json seams{Json::Array{}}, tacks{Json::Array{}}, json;
    for (const Checkpoint::Seam& seam : point.seams) seams.push(jsonOf(seam));
    for (const Checkpoint::Tack& tack : point.tacks) tacks.push(jsonOf(tack));
    json.set("format", "toile-checkpoint").set("version", version).set("scene", point.scene);
    json.set("time", point.time).set("steps", point.steps).set("phase", nameOf(point.phase));
    json.set("method", point.method).set("sewnTime", point.sewnTime).set("restingTime", point.restingTime);
    json.set("largestSpeed", point.largestSpeed).set("goesOnAsItLay", point.goesOnAsItLay);
    json.set("settles", point.settles).set("leaps", point.leaps);
    json.set("seams", std::move(seams)).set("tacks", std::move(tacks));
    json.set("positions", vectorsOf(point.positions)).set("velocities", vectorsOf(point.velocities));
    if (!point.hangsBy.empty()) json.set("hangsBy", numbersOf(point.hangsBy));
    if (!point.sewn.empty()) json.set("sewn", vectorsOf(point.sewn));
    if (!point.shown.empty()) json.set("shown", vectorsOf(point.shown));
    if (!point.contact.forces.empty()) json.set("contact", jsonOf(point.contact));
    return writeFileAtomically(path, toText(json));
}

Result<Checkpoint> readCheckpoint(const std::string& path) {
    const auto text = readRegularFile(path, largestCheckpoint);
    if (!text) return tl::unexpected(text.error());
    const auto json = parseJson(*text, path);
    if (!json) return tl::unexpected(json.error());
    JsonReading reading{path, {}};
    JsonNode root(&*json, "", reading);
    if (root.required("format").text() != "toile-checkpoint") root["format"].refuse("This is no checkpoint.");
    if (root.required("version").integer(version, 1, std::numeric_limits<int>::max()) > version)
        root["version"].refuse("This program knows checkpoints up to version 1.", ErrorCode::unsupported);
    Checkpoint point{.scene = root.required("scene").text(),
                     .time = numberFrom(root.required("time"), 0, longest),
                     .steps = root.required("steps").integer(0, 0, std::numeric_limits<int>::max()),
                     .phase = static_cast<simulation::Phase>(root.required("phase").choice(simulation::phaseNames, 0)),
                     .method = root.required("method").text(),
                     .sewnTime = numberFrom(root.required("sewnTime"), 0, longest),
                     .restingTime = numberFrom(root.required("restingTime"), 0, longest),
                     .largestSpeed = numberFrom(root.required("largestSpeed"), 0),
                     .goesOnAsItLay = root.required("goesOnAsItLay").truth(),
                     .settles = root["settles"].truth(),
                     .leaps = root["leaps"].truth()};
    for (JsonNode& seam : root.required("seams").items()) point.seams.push_back(seamOf(seam));
    for (JsonNode& tack : root["tacks"].items()) point.tacks.push_back(tackOf(tack));
    point.positions = vectorsOf(root.required("positions"));
    point.velocities = vectorsOf(root.required("velocities"));
    for (const JsonNode& node : root["hangsBy"].items())
        point.hangsBy.push_back(node.integer(0, 0, std::numeric_limits<int>::max()));
    point.sewn = vectorsOf(root["sewn"]);
    point.shown = vectorsOf(root["shown"]);
    if (JsonNode contact = root["contact"]; contact.exists()) point.contact = contactOf(contact);
    if (reading.error) return tl::unexpected(*reading.error);
    return point;
}

} // namespace toile::io
