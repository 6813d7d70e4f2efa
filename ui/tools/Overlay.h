// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <QString>

#include <vector>

namespace toile::ui {

/// What a tool wants to be seen above the pattern: values, so that tests can look at them.
struct Overlay {
    enum class Role { draft, accent, hover, sideA, sideB, warning };

    struct Line {
        std::vector<Vec2> points;
        Role role = Role::draft;
        bool dashed = false;
        bool filled = false; ///< closed, with a light tint
        double width = 1.6;  ///< [pixel]
    };
    struct Mark {
        Vec2 at;
        Role role = Role::draft;
        bool round = true;
    };
    /// An arrow head on a way: which way a seam runs.
    struct Arrow {
        Vec2 at, direction;
        Role role = Role::draft;
    };
    struct Label {
        Vec2 at;
        QString text;
        Role role = Role::draft;
    };
    struct Circle {
        Vec2 centre;
        double radius = 0; ///< [m]
        Role role = Role::draft;
    };

    std::vector<Line> lines;
    std::vector<Mark> marks;
    std::vector<Arrow> arrows;
    std::vector<Label> labels;
    std::vector<Circle> circles;
};

} // namespace toile::ui
