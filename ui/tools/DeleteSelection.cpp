// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/DeleteSelection.h"

#include "core/document/DocumentEdits.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternFolds.h"
#include "core/pattern/PatternPieces.h"
#include "core/pattern/PatternRegions.h"
#include "core/pattern/PatternSeams.h"
#include "core/pattern/PatternTacks.h"
#include "ui/values/Remarks.h"
#include "ui/values/ShapeOwner.h"
#include "ui/values/Words.h"

namespace toile::ui {
namespace {

using namespace pattern;

/// What an edit takes along is named; what has gone already, with something else, is passed over.
struct Without {
    const Pattern& pattern;
    QString& remarks;

    Result<Pattern> operator()(const SeamId& seam) const {
        return findSeam(pattern, seam) ? removeSeam(pattern, seam) : pattern;
    }
    Result<Pattern> operator()(const TackId& tack) const {
        return findTack(pattern, tack) ? removeTack(pattern, tack) : pattern;
    }
    Result<Pattern> operator()(const RegionRef& ref) const {
        if (existing({ref}, pattern).empty()) return pattern;
        return removeRegion(pattern, shapeOwner(pattern, ref.piece).piece, ref.region);
    }
    Result<Pattern> operator()(const FoldRef& ref) const {
        if (existing({ref}, pattern).empty()) return pattern;
        return removeFold(pattern, shapeOwner(pattern, ref.piece).piece, ref.fold);
    }
    Result<Pattern> operator()(const VertexRef& ref) const {
        if (existing({ref}, pattern).empty()) return pattern;
        return remarked(deleteVertex(pattern, shapeOwner(pattern, ref.piece).piece, ref.vertex));
    }
    Result<Pattern> operator()(const PieceId& piece) const {
        return findPiece(pattern, piece) ? remarked(deletePiece(pattern, piece)) : pattern;
    }
    template <class Other>
    Result<Pattern> operator()(const Other&) const {
        return pattern;
    }

    Result<Pattern> remarked(Result<Edited> edited) const {
        if (!edited) return tl::unexpected(edited.error());
        remarks += remarksOf(edited->warnings) + QLatin1Char(' ');
        return std::move(edited->pattern);
    }
};

struct StepName {
    QString operator()(const SeamId&) const { return tr("Delete seam"); }
    QString operator()(const TackId&) const { return tr("Delete tack"); }
    QString operator()(const RegionRef&) const { return tr("Delete region"); }
    QString operator()(const FoldRef&) const { return tr("Delete fold"); }
    QString operator()(const VertexRef&) const { return tr("Delete points"); }
    QString operator()(const PieceId&) const { return tr("Delete piece"); }
    template <class Other>
    QString operator()(const Other&) const {
        return {};
    }
};

} // namespace

Effect deleteSelection(const Desk& desk) {
    QString name, remarks;
    for (const Item& item : desk.selection)
        if (const QString step = std::visit(StepName{}, item); !step.isEmpty()) name = step;
    if (name.isEmpty()) return {};
    Effect effect = effectOf(name, document::edited(desk.document, [&](const Pattern& pattern, IdSource&) {
                                 Result<Pattern> result = pattern;
                                 for (const Item& item : desk.selection)
                                     if (result) result = std::visit(Without{*result, remarks}, item);
                                 return result;
                             }));
    if (effect.edit) effect.message = remarks.trimmed();
    return effect;
}

} // namespace toile::ui
