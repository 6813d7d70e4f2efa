// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/FrameFiles.h"

#include "core/base/AtomicFile.h"
#include "core/base/Contracts.h"
#include "core/base/Extension.h"
#include "core/io/DrapeExport.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>

namespace toile::io {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the point cache is little-endian");

template <class Number>
void put(std::ostream& out, Number number) {
    out.write(reinterpret_cast<const char*>(&number), sizeof number);
}

/// One file of plain floats; grows beside its final name, which it gets when it is whole.
class PointCache : public FrameFiles {
public:
    PointCache(fs::path path, std::size_t points)
        : path_(std::move(path)), growing_(path_.string() + ".part"), points_(points),
          out_(growing_, std::ios::binary | std::ios::trunc) {
        constexpr std::array<char, 12> magic{'P', 'O', 'I', 'N', 'T', 'C', 'A', 'C', 'H', 'E', '2', '\0'};
        out_.write(magic.data(), magic.size());
        put<std::int32_t>(out_, 1); // version
        put(out_, static_cast<std::int32_t>(points));
        put<float>(out_, 0);        // first frame
        put<float>(out_, 1);        // frames of the player for each of ours
        put<std::int32_t>(out_, 0); // how many frames: filled in at the end
    }
    ~PointCache() override {
        out_.close();
        std::error_code ignored;
        if (!finished_) fs::remove(growing_, ignored);
    }

    Result<void> add(std::span<const Vec3> positions) override {
        expects(positions.size() == points_);
        for (const Vec3& p : positions)
            for (int axis = 0; axis < 3; ++axis) put(out_, static_cast<float>(p[axis]));
        ++frames_;
        return sound();
    }

    Result<void> finish() override {
        out_.seekp(countAt);
        put(out_, frames_);
        out_.close();
        if (auto written = sound(); !written) return written;
        std::error_code problem;
        fs::rename(growing_, path_, problem);
        if (problem)
            return fail(ErrorCode::io, fmt::format("Cannot be written: {}.", problem.message()),
                        {.file = path_.string()});
        finished_ = true;
        return {};
    }

    [[nodiscard]] Result<void> sound() const {
        if (out_) return {};
        return fail(ErrorCode::io, "Cannot be written: is the disk full, or the folder not yours?",
                    {.file = path_.string()});
    }

private:
    static constexpr std::streamoff countAt = 28;

    fs::path path_, growing_;
    std::size_t points_;
    std::ofstream out_;
    std::int32_t frames_ = 0;
    bool finished_ = false;
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
        auto cache = std::make_unique<PointCache>(path, topology->material.size());
        if (const auto sound = cache->sound(); !sound) return tl::unexpected(sound.error());
        return cache;
    }
    if (const auto made = madeFolderFor(path); !made) return tl::unexpected(made.error());
    if (const auto empty = holdsNoFrames(path); !empty) return tl::unexpected(empty.error());
    return std::make_unique<ObjSequence>(path, std::move(topology));
}

} // namespace toile::io
