// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

#include <cstdint>
#include <cstring>

namespace toile::meshing {

/// Writes rectangles, and the triangles they are displayed as, one behind the other. Four numbers are moved at once:
/// in fine meshes this is what takes longest.
class CellWriter {
public:
    CellWriter(Rectangle* rectangles, std::array<int, 3>* display, bool mirrored)
        : rectangle_(rectangles), display_(display), mirrored_(mirrored) {}

    /// A cell, given by its two lower and its two upper corners from −x to +x of the frame, and the two triangles it is
    /// cut in.
    void add(const int* low, const int* high, int region) {
        const Four corners = cornersOf(low, high);
        addRectangle(corners, region);
        const Four triangles = mirrored_ ? __builtin_shuffle(corners, Four{0, 3, 1, 0})
                                         : __builtin_shuffle(corners, Four{0, 1, 3, 0}); // and the first of the next
        const Four rest =
            mirrored_ ? __builtin_shuffle(corners, Four{2, 3, 2, 3}) : __builtin_shuffle(corners, Four{3, 2, 3, 2});
        std::memcpy(static_cast<void*>(display_), &triangles, sizeof triangles);
        std::memcpy(&display_[1][1], &rest, 2 * sizeof(int));
        display_ += 2;
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
    typedef int Four __attribute__((vector_size(16)));

    static Four cornersOf(const int* low, const int* high) {
        typedef std::int64_t Two __attribute__((vector_size(16)));
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
        std::memcpy(rectangle_->nodes.data(), &nodes, sizeof nodes);
        rectangle_->region = region;
        ++rectangle_;
    }

    Rectangle* rectangle_;
    std::array<int, 3>* display_;
    bool mirrored_;
};

} // namespace toile::meshing
