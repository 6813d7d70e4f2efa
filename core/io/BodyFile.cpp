// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/BodyFile.h"

#include "core/base/Extension.h"
#include "core/base/RegularFile.h"
#include "core/io/AssimpMesh.h"
#include "core/io/BodyGlb.h"
#include "core/io/PlyReader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

namespace toile::io {
namespace {

namespace fs = std::filesystem;

struct BodyFormat {
    std::string_view extension;
    bool saysMetres = false; ///< lengths are metres by its standard, or are brought to metres by what the file says
};

constexpr std::array<BodyFormat, 7> formats{{{".glb", true},
                                             {".gltf", true},
                                             {".dae", true},
                                             {".fbx", true},
                                             {".obj", false},
                                             {".stl", false},
                                             {".ply", false}}};

Result<BodyFormat> formatOf(const fs::path& path) {
    const auto known = std::ranges::find(formats, extensionOf(path), &BodyFormat::extension);
    if (known == formats.end())
        return fail(ErrorCode::unsupported, "Is no body: GLB, glTF, OBJ, STL, PLY, DAE and FBX files are read.",
                    {.file = path.string()});
    return *known;
}

Result<void> checked(const geometry::TriangleMesh& mesh) {
    constexpr double farthest = 1e5; // [m], or in the file's unit: beyond it nothing is a body
    if (mesh.triangles.empty()) return fail(ErrorCode::invalidInput, "Contains no triangles.");
    for (const Vec3& v : mesh.vertices)
        if (!isFinite(v) || std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > farthest)
            return fail(ErrorCode::invalidInput, "A coordinate is not a finite number, or absurdly large.");
    const auto count = static_cast<int>(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle)
            if (corner < 0 || corner >= count)
                return fail(ErrorCode::invalidInput, "A triangle names a vertex that does not exist.");
    return {};
}

/// A body that we wrote is in metres, and a human one is as tall as humans are: somebody may have scaled the file.
Result<void> checkedOwn(const body::Body& body) {
    if (auto sound = checked(body.mesh); !sound || body.axes.empty()) return sound;
    auto sized = sizedAsBody(body.mesh, true, std::nullopt);
    return sized ? Result<void>() : tl::unexpected(sized.error());
}

/// What a file holds: a body of ours, or only a mesh.
struct Content {
    std::optional<body::Body> body;
    ImportedMesh imported;
};

Result<Content> contentOf(const fs::path& path, const BodyFormat& format, const BodyImportSettings& settings) {
    const auto bytes = readRegularFile(path, settings.largestFile); // also the check of the file for the others
    if (!bytes) return tl::unexpected(bytes.error());
    if (bytes->empty()) return fail(ErrorCode::invalidInput, "Is empty.");
    Content content;
    if (format.extension == ".ply") {
        auto mesh = meshFromPly(*bytes);
        if (!mesh) return tl::unexpected(mesh.error());
        content.imported.mesh = std::move(*mesh);
        return content;
    }
    if (format.extension == ".glb") {
        const auto glb = parseGlb(*bytes);
        if (!glb) return tl::unexpected(glb.error());
        auto body = bodyOf(*glb, path.string());
        if (!body) return tl::unexpected(body.error());
        content.body = std::move(*body);
        if (content.body) return content;
    }
    auto imported = meshThroughAssimp(path, {.seconds = settings.patience});
    if (!imported) return tl::unexpected(imported.error());
    content.imported = std::move(*imported);
    return content;
}

Result<geometry::TriangleMesh> finished(ImportedMesh imported, const BodyFormat& format,
                                        const BodyImportSettings& settings, std::vector<Warning>& warnings) {
    if (auto sound = checked(imported.mesh); !sound) return tl::unexpected(sound.error());
    auto sized = settings.isHuman ? sizedAsBody(std::move(imported.mesh), format.saysMetres, settings.unit)
                                  : scaledToMetres(std::move(imported.mesh), settings.unit.value_or(LengthUnit::metre));
    if (!sized) return tl::unexpected(sized.error());
    warnings.insert(warnings.end(), imported.warnings.begin(), imported.warnings.end());
    warnings.insert(warnings.end(), sized->warnings.begin(), sized->warnings.end());
    geometry::TriangleMesh mesh = geometry::welded(sized->mesh, settings.weldDistance);
    if (mesh.triangles.empty()) return fail(ErrorCode::invalidInput, "Contains no triangle with an area.");
    if (!geometry::isClosedManifold(mesh)) {
        warnings.push_back({"body", "Its surface is not closed: cloth may come to lie inside it."});
    } else if (geometry::signedVolume(mesh) < 0) {
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        warnings.push_back({"body", "Its triangles faced inward and were turned round."});
    }
    return mesh;
}

} // namespace

Result<BodyFile> readBodyFile(const std::filesystem::path& path, const BodyImportSettings& settings,
                              std::vector<Warning>* warnings) {
    const auto format = formatOf(path);
    if (!format) return tl::unexpected(format.error());
    const auto named = [&](Error error) {
        error.place.file = path.string();
        return tl::unexpected(std::move(error));
    };
    auto content = contentOf(path, *format, settings);
    if (!content) return named(content.error());
    if (content->body) {
        if (auto sound = checkedOwn(*content->body); !sound) return named(sound.error());
        return BodyFile{std::move(content->body), {}};
    }
    std::vector<Warning> found;
    auto mesh = finished(std::move(content->imported), *format, settings, found);
    if (!mesh) return named(mesh.error());
    for (Warning& warning : found) {
        warning.place = path.string();
        if (warnings) warnings->push_back(std::move(warning));
    }
    return BodyFile{std::nullopt, std::move(*mesh)};
}

bool isBodyFile(const fs::path& path) {
    return formatOf(path).has_value();
}

Result<PoseFile> readPose(const fs::path& path, std::optional<PoseReading> reading) {
    const auto format = formatOf(path);
    if (!format) return tl::unexpected(format.error());
    const auto named = [&](Error error) {
        error.place.file = path.string();
        return tl::unexpected(std::move(error));
    };
    auto content = contentOf(path, *format, {});
    if (!content) return named(content.error());
    geometry::TriangleMesh mesh = content->body ? std::move(content->body->mesh) : std::move(content->imported.mesh);
    if (auto sound = checked(mesh); !sound) return named(sound.error());
    const bool first = !reading;
    auto sized = first ? sizedAsBody(std::move(mesh), format->saysMetres || content->body, std::nullopt)
                       : scaledToMetres(std::move(mesh), reading->unit);
    if (!sized) return named(sized.error());
    PoseFile pose{std::move(sized->mesh.vertices), first ? PoseReading{sized->unit, sized->stoodUp} : *reading};
    if (!first && reading->stoodUp)
        for (Vec3& v : pose.vertices) v = stoodUp(v);
    return pose;
}

} // namespace toile::io
