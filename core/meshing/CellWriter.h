// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/meshing/Streaming.h"

#include <cstdint>
#include <cstring>

namespace toile::meshing {

/// Writes rectangles, and the triangles they are displayed as, one behind the other. Four numbers are moved at once:
/// in fine meshes this is what takes longest.
class CellWriter {
public:
    CellWriter(Rectangle* rectangles, std::array<int, 3>* display, bool mirrored, bool streamed)
        : rectangle_(rectangles), display_(display), mirrored_(mirrored), streamed_(streamed) {}

    /// A cell, given by its two lower and its two upper corners from −x to +x of the frame, and the two triangles it is
    /// cut in.
    void add(const int* low, const int* high, int region) {
        const Four corners = cornersOf(low, high);
        addRectangle(corners, region);
        const Four triangles = mirrored_ ? __builtin_shuffle(corners, Four{0, 3, 1, 0})
                                         : __builtin_shuffle(corners, Four{0, 1, 3, 0}); // and the first of the next
        const Four rest =
            mirrored_ ? __builtin_shuffle(corners, Four{2, 3, 2, 3}) : __builtin_shuffle(corners, Four{3, 2, 3, 2});
        const auto bytes = reinterpret_cast<char*>(display_);
        display_ += 2;
        if (streamed_) {
            stream(bytes, Two(triangles)[0]);
            stream(bytes + 8, Two(triangles)[1]);
            stream(bytes + 16, Two(rest)[0]);
            return;
        }
        std::memcpy(bytes, &triangles, sizeof triangles);
        std::memcpy(bytes + 16, &rest, 8);
    }
    void addRectangle(const int* low, const int* high, int region) { addRectangle(cornersOf(low, high), region); }
    void addTriangle(const std::array<int, 3>& nodes) { *display_++ = nodes; }

    [[nodiscard]] std::size_t rectangles(const Rectangle* first) const {
        return static_cast<std::size_t>(rectangle_ - first);
    }
    [[nodiscard]] std::size_t displayed(const std::array<int, 3>* first) const {
        return static_cast<std::size_t>(display_ - first);
    }

private:
    typedef std::int32_t Four __attribute__((vector_size(16)));
    typedef std::int64_t Two __attribute__((vector_size(16))); ///< the same four, two by two

    static Four cornersOf(const int* low, const int* high) {
        Two pairs{};
        for (int i = 0; i < 2; ++i) {
            std::int64_t pair = 0;
            std::memcpy(&pair, i == 0 ? low : high, sizeof pair);
            pairs[i] = pair;
        }
        return Four(pairs);
    }
    void addRectangle(Four corners, int region) {
        const Four nodes =
            mirrored_ ? __builtin_shuffle(corners, Four{1, 0, 2, 3}) : __builtin_shuffle(corners, Four{0, 1, 3, 2});
        if (streamed_) streamRectangle(nodes, region);
        else *rectangle_ = rectangleOf(nodes, region);
        ++rectangle_;
    }
    static Rectangle rectangleOf(Four nodes, int region) {
        Rectangle rectangle{{}, region};
        std::memcpy(rectangle.nodes.data(), &nodes, sizeof nodes);
        return rectangle;
    }
    /// Two numbers at once where they are aligned: every other rectangle begins between two.
    void streamRectangle(Four nodes, int region) {
        const auto bytes = reinterpret_cast<char*>(rectangle_);
        if (reinterpret_cast<std::uintptr_t>(bytes) % 8 == 0) {
            stream(bytes, Two(nodes)[0]);
            stream(bytes + 8, Two(nodes)[1]);
            stream(bytes + 16, region);
        } else {
            const Four turned = __builtin_shuffle(nodes, Four{region, region, region, region}, Four{1, 2, 3, 4});
            stream(bytes, nodes[0]);
            stream(bytes + 4, Two(turned)[0]);
            stream(bytes + 12, Two(turned)[1]);
        }
    }

    Rectangle* rectangle_;
    std::array<int, 3>* display_;
    bool mirrored_, streamed_;
};

} // namespace toile::meshing
