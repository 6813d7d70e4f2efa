// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternPieces.h"
#include "ui/tools/Tool.h"

#include <array>

namespace toile::ui {

/// A rectangle on the table, its origin in its middle.
inline document::Document withRectangle(const document::Document& document, const char* name, Vec2 middle, double width,
                                        double height) {
    auto edited =
        document::edited(document, [&](const pattern::Pattern& p, pattern::IdSource& ids) -> Result<pattern::Pattern> {
            const std::array<Vec2, 4> corners{{{-width / 2, -height / 2},
                                               {width / 2, -height / 2},
                                               {width / 2, height / 2},
                                               {-width / 2, height / 2}}};
            auto outline = contourThrough(corners, {}, ids);
            if (!outline) return tl::unexpected(outline.error());
            pattern::Piece piece;
            piece.id = ids.take<pattern::PieceId>();
            piece.name = name;
            piece.outline = std::move(*outline);
            piece.tablePosition = middle;
            return addPiece(p, std::move(piece));
        });
    return std::move(*edited);
}

/// Two rectangles of 200 × 300 mm, "Front" at the origin and "Back" 300 mm to its right.
inline document::Document twoRectangles() {
    return withRectangle(withRectangle({}, "Front", {0, 0}, 0.2, 0.3), "Back", {0.3, 0}, 0.2, 0.3);
}

/// Feeds a tool as a window would, and keeps what comes of it.
struct Hand {
    document::Document document;
    Selection selection;
    QString message;
    bool refused = false;
    int edits = 0;
    std::string lastKey;

    Hand(document::Document d) : document(std::move(d)) {}

    template <class Event>
    void feed(Event&& event) {
        const FlatPattern flat = flattened(document.pattern);
        const Effect effect = event(Desk{document, flat, selection});
        refused = effect.refused;
        if (!effect.message.isEmpty()) message = effect.message;
        if (effect.edit) {
            document = effect.edit->after;
            lastKey = effect.edit->mergeKey;
            ++edits;
        }
        if (effect.selection) selection = existing(*effect.selection, document.pattern);
    }
    void press(Tool& tool, Vec2 at, Modifiers modifiers = {}) {
        feed([&](const Desk& desk) { return tool.press(desk, {at, Button::left, modifiers, 0.004}); });
    }
    void move(Tool& tool, Vec2 at, Modifiers modifiers = {}) {
        feed([&](const Desk& desk) { return tool.move(desk, {at, Button::none, modifiers, 0.004}); });
    }
    void release(Tool& tool, Vec2 at) {
        feed([&](const Desk& desk) { return tool.release(desk, {at, Button::left, {}, 0.004}); });
    }
    void click(Tool& tool, Vec2 at, Modifiers modifiers = {}) {
        move(tool, at, modifiers);
        press(tool, at, modifiers);
        release(tool, at);
    }
    void doubleClick(Tool& tool, Vec2 at) {
        click(tool, at);
        feed([&](const Desk& desk) { return tool.doubleClick(desk, {at, Button::left, {}, 0.004}); });
        release(tool, at);
    }
    void drag(Tool& tool, Vec2 from, Vec2 to, Modifiers modifiers = {}) {
        press(tool, from, modifiers);
        move(tool, lerp(from, to, 0.5), modifiers);
        move(tool, to, modifiers);
        release(tool, to);
    }
    void key(Tool& tool, ToolKey key) {
        feed([&](const Desk& desk) { return tool.key(desk, key); });
    }
    Overlay overlay(const Tool& tool) const {
        const FlatPattern flat = flattened(document.pattern);
        return tool.overlay({document, flat, selection});
    }
    const pattern::Piece& piece(std::size_t i) const { return *document.pattern.pieces[i]; }
};

constexpr Modifiers shift{.shift = true};

} // namespace toile::ui
