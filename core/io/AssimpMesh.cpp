// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/AssimpMesh.h"

#include "core/base/Extension.h"

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>

namespace toile::io {
namespace {

constexpr char meshAnswer = 'M', errorAnswer = 'E';

/// What the child sends before the vertices and triangles.
struct AnswerHead {
    std::uint64_t vertices = 0, triangles = 0;
    std::uint64_t onlyBody = 0; ///< parts beside the one called "body" were left out
};

bool isCalledBody(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name == "body";
}

/// assimp numbers the primitives of a glTF mesh: "body-0", "body-1".
std::string withoutNumber(const std::string& name) {
    const auto dash = name.find_last_not_of("0123456789");
    const bool numbered = dash != std::string::npos && name[dash] == '-' && dash + 1 < name.size();
    return numbered ? name.substr(0, dash) : name;
}

/// What a modelling program shows as the name of a part is the node's in glTF, where meshes have names of their own.
bool isBody(const aiNode& node, const aiMesh& mesh) {
    return isCalledBody(node.mName.C_Str()) || isCalledBody(withoutNumber(mesh.mName.C_Str()));
}

/// FBX states its axes but assimp does not apply them: which coordinate is to the side, up and to the front, and its
/// sign.
struct Axes {
    std::array<int, 3> from{0, 1, 2};
    std::array<double, 3> sign{1, 1, 1};

    [[nodiscard]] Vec3 turned(const Vec3& p) const {
        return {sign[0] * p[from[0]], sign[1] * p[from[1]], sign[2] * p[from[2]]};
    }
};

Axes axesOf(const aiScene& scene) {
    Axes axes;
    if (!scene.mMetaData) return axes;
    const std::array<const char*, 3> names{"CoordAxis", "UpAxis", "FrontAxis"};
    std::set<int> used;
    for (std::size_t i = 0; i < 3; ++i) {
        std::int32_t axis = 0, sign = 1;
        if (!scene.mMetaData->Get(std::string(names[i]), axis) || axis < 0 || axis > 2) return {};
        scene.mMetaData->Get(std::string(names[i]) + "Sign", sign);
        axes.from[i] = axis;
        axes.sign[i] = sign < 0 ? -1 : 1;
        used.insert(axis);
    }
    return used.size() == 3 ? axes : Axes{};
}

/// Collects the triangles of all nodes; called in the child.
class Collector {
public:
    explicit Collector(const aiScene& scene) : scene_(scene), axes_(axesOf(scene)) {
        lookAt(*scene.mRootNode);
        head.onlyBody = hasBody_ && hasOthers_;
    }

    void add(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 here = parent * node.mTransformation;
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            if (const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[m]]; !head.onlyBody || isBody(node, mesh))
                add(mesh, here);
        for (unsigned c = 0; c < node.mNumChildren; ++c) add(*node.mChildren[c], here);
    }

    AnswerHead head;
    std::string vertices, triangles;

private:
    void lookAt(const aiNode& node) {
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            (isBody(node, *scene_.mMeshes[node.mMeshes[m]]) ? hasBody_ : hasOthers_) = true;
        for (unsigned c = 0; c < node.mNumChildren; ++c) lookAt(*node.mChildren[c]);
    }

    void add(const aiMesh& mesh, const aiMatrix4x4& transform) {
        const auto first = static_cast<std::int32_t>(head.vertices);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D at = transform * mesh.mVertices[v];
            const Vec3 turned = axes_.turned({at.x, at.y, at.z});
            vertices.append(reinterpret_cast<const char*>(&turned), sizeof turned);
        }
        head.vertices += mesh.mNumVertices;
        const bool mirrored = transform.Determinant() < 0;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) continue;
            std::array<std::int32_t, 3> t{};
            for (unsigned k = 0; k < 3; ++k) t[k] = first + static_cast<std::int32_t>(face.mIndices[k]);
            if (mirrored) std::swap(t[1], t[2]);
            triangles.append(reinterpret_cast<const char*>(t.data()), sizeof t);
            ++head.triangles;
        }
    }

    const aiScene& scene_;
    Axes axes_;
    bool hasBody_ = false, hasOthers_ = false;
};

/// In the child: the answer to be sent home.
std::string readWithAssimp(const std::string& path, bool hasUnit) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_LINE | aiPrimitiveType_POINT);
    const unsigned flags = aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType |
                           (hasUnit ? aiProcess_GlobalScale : 0u);
    const aiScene* scene = importer.ReadFile(path, flags);
    if (!scene || !scene->mRootNode) return errorAnswer + std::string(importer.GetErrorString());
    Collector collector(*scene);
    collector.add(*scene->mRootNode, {});
    std::string answer(1, meshAnswer);
    answer.append(reinterpret_cast<const char*>(&collector.head), sizeof collector.head);
    return answer + collector.vertices + collector.triangles;
}

tl::unexpected<Error> damaged(const std::string& what, const std::filesystem::path& path) {
    return fail(ErrorCode::invalidInput, what, {.file = path.string()});
}

Result<ImportedMesh> fromAnswer(std::string_view answer, const std::filesystem::path& path) {
    AnswerHead head;
    if (answer.empty()) return damaged("Contains nothing that can be read.", path);
    if (answer[0] == errorAnswer) return damaged("Cannot be read: " + std::string(answer.substr(1)) + ".", path);
    if (answer.size() < 1 + sizeof head) return damaged("Contains nothing that can be read.", path);
    std::memcpy(&head, answer.data() + 1, sizeof head);
    answer.remove_prefix(1 + sizeof head);
    ImportedMesh imported;
    if (answer.size() != head.vertices * sizeof(Vec3) + head.triangles * sizeof(geometry::TriangleIndices))
        return damaged("Was read only in part.", path);
    imported.mesh.vertices.resize(head.vertices);
    imported.mesh.triangles.resize(head.triangles);
    if (head.vertices > 0) std::memcpy(imported.mesh.vertices.data(), answer.data(), head.vertices * sizeof(Vec3));
    if (head.triangles > 0)
        std::memcpy(imported.mesh.triangles.data(), answer.data() + head.vertices * sizeof(Vec3),
                    head.triangles * sizeof(geometry::TriangleIndices));
    if (head.onlyBody)
        imported.warnings.push_back(
            {path.string(), "Only the part called \"body\" was taken; other parts were left out."});
    return imported;
}

} // namespace

Result<ImportedMesh> meshThroughAssimp(const std::filesystem::path& path, const ChildLimits& limits) {
    const bool isFbx = extensionOf(path) == ".fbx";
    const auto answer = runInChild([&] { return readWithAssimp(path.string(), isFbx); }, limits);
    if (!answer) return fail(answer.error().code, answer.error().text, {.file = path.string()});
    return fromAnswer(*answer, path);
}

} // namespace toile::io
