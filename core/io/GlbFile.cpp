// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/GlbFile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

static_assert(std::endian::native == std::endian::little, "GLB and binary PLY are written as they lie in memory");

namespace toile::io {
namespace {

constexpr std::uint32_t magic = 0x46546C67, jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
constexpr int floatType = 5126, indexType = 5125, vertexTarget = 34962, indexTarget = 34963;

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

void pad(std::string& bytes, char with) {
    while (bytes.size() % 4) bytes.push_back(with);
}

tl::unexpected<Error> broken(const std::string& what, const std::string& file) {
    return fail(ErrorCode::invalidInput, "Is not a sound GLB file: " + what, {.file = file});
}

/// A whole number from 0 on; none for anything else.
std::optional<std::size_t> countAt(const Json* object, const char* key) {
    const Json* found = object ? object->find(key) : nullptr;
    const double* number = found ? found->asNumber() : nullptr;
    if (!number || *number < 0 || *number > 4e9 || *number != std::floor(*number)) return std::nullopt;
    return static_cast<std::size_t>(*number);
}

const Json* itemAt(const Json* list, std::size_t index) {
    const Json::Array* items = list ? list->asArray() : nullptr;
    return items && index < items->size() ? &(*items)[index] : nullptr;
}

/// The bytes of an accessor of the given kind, and how many values they are.
struct AccessorBytes {
    std::string_view bytes;
    std::size_t count = 0;
};

std::optional<AccessorBytes> accessorBytes(const GlbFile& glb, std::optional<std::size_t> index, int componentType,
                                           const char* type, std::size_t valueSize) {
    if (!index) return std::nullopt;
    const Json* accessor = itemAt(glb.json.find("accessors"), *index);
    const auto count = countAt(accessor, "count"), view = countAt(accessor, "bufferView");
    const Json* kind = accessor ? accessor->find("type") : nullptr;
    if (!count || !view || countAt(accessor, "componentType") != static_cast<std::size_t>(componentType) || !kind ||
        !kind->asString() || *kind->asString() != type)
        return std::nullopt;
    const Json* bufferView = itemAt(glb.json.find("bufferViews"), *view);
    if (!bufferView || bufferView->find("byteStride") || countAt(bufferView, "buffer") != std::size_t{0})
        return std::nullopt;
    const std::size_t offset =
        countAt(bufferView, "byteOffset").value_or(0) + countAt(accessor, "byteOffset").value_or(0);
    if (offset > glb.binary.size() || *count > (glb.binary.size() - offset) / valueSize) return std::nullopt;
    return AccessorBytes{std::string_view(glb.binary).substr(offset, *count * valueSize), *count};
}

} // namespace

Result<GlbFile> parseGlb(std::string_view bytes, const std::string& file) {
    if (bytes.size() < 20 || wordAt(bytes, 0) != magic) return broken("it does not begin as one.", file);
    if (wordAt(bytes, 4) != 2) return broken("only version 2 is read.", file);
    GlbFile glb;
    bool haveJson = false;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t length = wordAt(bytes, at), kind = wordAt(bytes, at + 4);
        if (length > bytes.size() - at - 8) return broken("it ends in the middle of a chunk.", file);
        const std::string_view content = bytes.substr(at + 8, length);
        if (kind == jsonChunk && !haveJson) {
            auto json = parseJson(content, file);
            if (!json) return tl::unexpected(json.error());
            glb.json = std::move(*json);
            haveJson = true;
        } else if (kind == binaryChunk && glb.binary.empty()) {
            glb.binary = content;
        }
        at += 8 + length;
    }
    if (!haveJson) return broken("it has no JSON chunk.", file);
    return glb;
}

std::string toBytes(const GlbFile& glb) {
    std::string json = toLine(glb.json), binary = glb.binary;
    pad(json, ' ');
    pad(binary, '\0');
    std::string bytes;
    append(bytes, magic);
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
    append(bytes, static_cast<std::uint32_t>(json.size()));
    append(bytes, jsonChunk);
    bytes += json;
    append(bytes, static_cast<std::uint32_t>(binary.size()));
    append(bytes, binaryChunk);
    bytes += binary;
    return bytes;
}

int GlbArrays::addAccessor(std::string_view bytes, int componentType, std::size_t count, const char* type, int target) {
    Json view;
    view.set("buffer", 0).set("byteOffset", binary_.size()).set("byteLength", bytes.size()).set("target", target);
    binary_ += bytes;
    pad(binary_, '\0');
    views_.push_back(std::move(view));
    Json accessor;
    accessor.set("bufferView", views_.size() - 1).set("componentType", componentType);
    accessor.set("count", count).set("type", type);
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
}

int GlbArrays::add(std::span<const Vec3> values, bool withBounds) {
    constexpr float most = std::numeric_limits<float>::max();
    std::string bytes;
    bytes.reserve(values.size() * 12);
    float low[3]{most, most, most}, high[3]{-most, -most, -most};
    for (const Vec3& v : values)
        for (int axis = 0; axis < 3; ++axis) {
            const auto x = static_cast<float>(v[axis]);
            append(bytes, x);
            low[axis] = std::min(low[axis], x);
            high[axis] = std::max(high[axis], x);
        }
    const int index = addAccessor(bytes, floatType, values.size(), "VEC3", vertexTarget);
    if (withBounds && !values.empty()) {
        const auto triple = [](const float(&v)[3]) {
            return Json(Json::Array{double(v[0]), double(v[1]), double(v[2])});
        };
        accessors_.back().set("min", triple(low)).set("max", triple(high));
    }
    return index;
}

int GlbArrays::add(std::span<const Vec2> values) {
    std::string bytes;
    bytes.reserve(values.size() * 8);
    for (const Vec2& v : values) {
        append(bytes, static_cast<float>(v.x));
        append(bytes, static_cast<float>(v.y));
    }
    return addAccessor(bytes, floatType, values.size(), "VEC2", vertexTarget);
}

int GlbArrays::add(std::span<const geometry::TriangleIndices> triangles, int firstVertex) {
    std::string bytes;
    bytes.reserve(triangles.size() * 12);
    for (const auto& triangle : triangles)
        for (const int corner : triangle) append(bytes, static_cast<std::uint32_t>(corner - firstVertex));
    return addAccessor(bytes, indexType, triangles.size() * 3, "SCALAR", indexTarget);
}

GlbFile GlbArrays::finish(Json json) && {
    Json buffer;
    buffer.set("byteLength", binary_.size());
    json.set("accessors", Json(std::move(accessors_))).set("bufferViews", Json(std::move(views_)));
    json.set("buffers", Json(Json::Array{std::move(buffer)}));
    return {std::move(json), std::move(binary_)};
}

Result<geometry::TriangleMesh> firstMesh(const GlbFile& glb, const std::string& file) {
    const Json* mesh = itemAt(glb.json.find("meshes"), 0);
    const Json* primitive = mesh ? itemAt(mesh->find("primitives"), 0) : nullptr;
    const Json* attributes = primitive ? primitive->find("attributes") : nullptr;
    const auto positions = accessorBytes(glb, countAt(attributes, "POSITION"), floatType, "VEC3", 12);
    const auto indices = accessorBytes(glb, countAt(primitive, "indices"), indexType, "SCALAR", 4);
    if (!positions || !indices) return broken("its mesh is not stored as toile-cli stores bodies.", file);

    geometry::TriangleMesh result;
    result.vertices.reserve(positions->count);
    for (std::size_t i = 0; i < positions->count; ++i) {
        float p[3];
        std::memcpy(p, positions->bytes.data() + i * sizeof p, sizeof p);
        result.vertices.push_back({p[0], p[1], p[2]});
    }
    result.triangles.reserve(indices->count / 3);
    for (std::size_t i = 0; i + 3 <= indices->count; i += 3) {
        std::uint32_t t[3];
        std::memcpy(t, indices->bytes.data() + i * 4, sizeof t);
        if (std::ranges::any_of(t, [&](std::uint32_t corner) { return corner >= positions->count; }))
            return broken("a triangle names a vertex that does not exist.", file);
        result.triangles.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
    }
    return result;
}

} // namespace toile::io
