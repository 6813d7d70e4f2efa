// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/FrameFiles.h"

#include "core/base/AtomicFile.h"
#include "core/base/Contracts.h"
#include "core/base/Extension.h"
#include "core/io/DrapeExport.h"

#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <utility>

namespace toile::io {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the point cache is little-endian");

template <class Number>
void put(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string cacheHead(std::size_t points) {
    std::string head("POINTCACHE2\0", 12);
    put<std::int32_t>(head, 1); // version
    put(head, static_cast<std::int32_t>(points));
    put<float>(head, 0);        // first frame
    put<float>(head, 1);        // frames of the player for each of ours
    put<std::int32_t>(head, 0); // how many frames: filled in at the end
    return head;
}

/// One file of plain floats, there when it is whole.
class PointCache : public FrameFiles {
public:
    PointCache(AtomicFile file, std::size_t points) : file_(std::move(file)), points_(points) {}

    Result<void> add(std::span<const Vec3> positions) override {
        expects(positions.size() == points_);
        std::string bytes;
        bytes.reserve(positions.size() * 3 * sizeof(float));
        for (const Vec3& p : positions)
            for (int axis = 0; axis < 3; ++axis) put(bytes, static_cast<float>(p[axis]));
        ++frames_;
        return file_.append(bytes);
    }

    Result<void> finish() override {
        constexpr std::int64_t countAt = 28;
        std::string count;
        put(count, frames_);
        if (auto written = file_.overwrite(countAt, count); !written) return written;
        return file_.finish();
    }

private:
    AtomicFile file_;
    std::size_t points_;
    std::int32_t frames_ = 0;
};

fs::path frameIn(const fs::path& folder, int number) {
    return folder / fmt::format("frame-{:05}.obj", number);
}

/// frame-00000.obj, frame-00001.obj, … in one folder.
class ObjSequence : public FrameFiles {
public:
    ObjSequence(fs::path folder, Shared<simulation::FrameTopology> topology)
        : folder_(std::move(folder)), topology_(std::move(topology)) {}

    Result<void> add(std::span<const Vec3> positions) override {
        return writeFileAtomically(frameIn(folder_, frames_++), drapeObj(*topology_, positions));
    }
    Result<void> finish() override { return {}; }

private:
    fs::path folder_;
    Shared<simulation::FrameTopology> topology_;
    int frames_ = 0;
};

bool isPointCache(const fs::path& path) {
    return extensionOf(path) == ".pc2";
}

Result<void> madeFolderFor(const fs::path& folder) {
    std::error_code problem;
    fs::create_directory(folder, problem);
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return {};
    return fail(ErrorCode::io, fmt::format("The folder cannot be made: {}.", problem.message()),
                {.file = folder.string()});
}

Result<void> holdsNoFrames(const fs::path& folder) {
    std::error_code problem;
    auto entry = fs::directory_iterator(folder, problem);
    const auto isFrame = [&] { return entry->path().filename().string().starts_with("frame-"); };
    while (!problem && entry != fs::directory_iterator() && !isFrame()) entry.increment(problem);
    if (problem)
        return fail(ErrorCode::io, fmt::format("The folder cannot be read: {}.", problem.message()),
                    {.file = folder.string()});
    if (entry != fs::directory_iterator())
        return fail(ErrorCode::io, "The folder holds frames of another run: empty it, or name another.",
                    {.file = folder.string()});
    return {};
}

} // namespace

Result<void> FrameFiles::checkWritable(const fs::path& path) {
    std::error_code unknown;
    if (isPointCache(path) || !fs::exists(path, unknown)) return toile::checkWritable(path);
    if (!fs::is_directory(path, unknown))
        return fail(ErrorCode::io, "This is a file: name a folder for the frames, or a .pc2.", {.file = path.string()});
    if (auto empty = holdsNoFrames(path); !empty) return empty;
    return toile::checkWritable(frameIn(path, 0));
}

Result<std::unique_ptr<FrameFiles>> FrameFiles::create(const fs::path& path,
                                                       Shared<simulation::FrameTopology> topology) {
    if (isPointCache(path)) {
        const std::size_t points = topology->material.size();
        auto file = AtomicFile::create(path);
        if (!file) return tl::unexpected(file.error());
        if (auto begun = file->append(cacheHead(points)); !begun) return tl::unexpected(begun.error());
        return std::make_unique<PointCache>(std::move(*file), points);
    }
    if (const auto made = madeFolderFor(path); !made) return tl::unexpected(made.error());
    if (const auto empty = holdsNoFrames(path); !empty) return tl::unexpected(empty.error());
    return std::make_unique<ObjSequence>(path, std::move(topology));
}

} // namespace toile::io
