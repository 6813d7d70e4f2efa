// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"
#include "core/meshing/GarmentMesh.h"
#include "ui/tools/Tool.h"
#include "ui/values/Units.h"

#include <QStringList>

#include <functional>
#include <variant>
#include <vector>

namespace toile::ui {

using DocumentResult = Result<document::Document>;

/// A number with its unit; value, low, high and step as the core counts them, but for step, which is as shown.
struct NumberRow {
    Quantity quantity = Quantity::factor;
    double value = 0, low = 0, high = 1;
    double step = 1; ///< of the spin box [shown unit]
    std::function<DocumentResult(const document::Document&, double)> set;
    QString lowest = {}; ///< what the lowest number means; empty = itself
};
struct TextRow {
    QString text;
    std::function<DocumentResult(const document::Document&, const QString&)> set;
};
struct ChoiceRow {
    QStringList choices;
    int current = 0;
    std::function<DocumentResult(const document::Document&, int)> set;
};
struct FlagRow {
    bool on = false;
    std::function<DocumentResult(const document::Document&, bool)> set;
};
/// Something to read.
struct FactRow {
    QString text;
    bool isProblem = false;
};
/// A button.
struct ActionRow {
    std::function<DocumentResult(const document::Document&)> act;
    std::function<QString(const document::Document&)> losses = {}; ///< that go with it, for the status line
};
/// Begins a group.
struct HeadingRow {};

struct PropertyRow {
    QString name; ///< of the widget, for tests: never translated
    QString label;
    std::variant<NumberRow, TextRow, ChoiceRow, FlagRow, FactRow, ActionRow, HeadingRow> content;
    QString tip = {};
};

/// What can be read and changed of one thing.
struct PropertySheet {
    QString title;
    std::vector<PropertyRow> rows;
};

/// What pressing a button does; what goes with it is told.
[[nodiscard]] Effect effectOf(const QString& name, const ActionRow& action, const document::Document& document);

/// The sheet of the last selected thing; of the scene when nothing is selected.
[[nodiscard]] PropertySheet sheetOf(const Desk& desk, const meshing::MeshReport& mesh);

[[nodiscard]] PropertySheet pieceSheet(const document::Document& document, const pattern::Piece& piece,
                                       const meshing::MeshReport& mesh);
[[nodiscard]] PropertySheet regionSheet(const document::Document& document, const RegionRef& region);
[[nodiscard]] PropertySheet edgeSheet(const Desk& desk, const EdgeRef& edge);
[[nodiscard]] PropertySheet vertexSheet(const Desk& desk, const VertexRef& vertex);
[[nodiscard]] PropertySheet foldSheet(const document::Document& document, const FoldRef& fold);
[[nodiscard]] PropertySheet seamSheet(const Desk& desk, const pattern::Seam& seam);
[[nodiscard]] PropertySheet tackSheet(const document::Document& document, const pattern::Tack& tack);
[[nodiscard]] PropertySheet fabricSheet(const document::Document& document, const material::Fabric& fabric);
[[nodiscard]] PropertySheet sceneSheet(const document::Document& document);

} // namespace toile::ui
