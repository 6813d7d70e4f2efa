// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

namespace toile::ui {

enum class Button { none, left, right, middle };

struct Modifiers {
    bool shift = false, control = false, alt = false;
    friend bool operator==(Modifiers, Modifiers) = default;
};

/// What the pointer does, in the words of the pattern: no widget, no pixels.
struct PointerEvent {
    Vec2 position;                ///< in the plane of the pattern [m]
    Button button = Button::none; ///< the one that went down or up; while moving, the one held
    Modifiers modifiers;
    double tolerance = 1e-3; ///< what counts as touching [m]: a few pixels at the present zoom
};

/// Keys that tools understand.
enum class ToolKey { enter, escape, backspace, erase };

} // namespace toile::ui
