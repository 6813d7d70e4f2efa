// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/ObjectList.h"
#include "ui/values/Words.h"

#include <QFileInfo>
#include <QIcon>

#include <algorithm>

namespace toile::ui {
namespace {

using namespace pattern;

QString named(const std::string& name, const QString& otherwise) {
    return name.empty() ? otherwise : QString::fromStdString(name);
}

ObjectGroup piecesOf(const Pattern& pattern) {
    ObjectGroup group{tr("Pieces"), {}};
    for (const auto& piece : pattern.pieces) {
        group.lines.push_back({piece->id, named(piece->name, tr("(no name)")), QStringLiteral("piece"), 0});
        for (const Region& region : piece->regions)
            group.lines.push_back(
                {RegionRef{piece->id, region.id},
                 tr("%1 (1/%2)").arg(named(region.name, tr("Region"))).arg(1 << std::clamp(region.refinement, 0, 20)),
                 QStringLiteral("region"), 1});
        for (const Fold& fold : piece->folds)
            group.lines.push_back(
                {FoldRef{piece->id, fold.id}, named(fold.name, tr("Fold")), QStringLiteral("fold"), 1});
    }
    return group;
}

ObjectGroup seamsOf(const Pattern& pattern) {
    ObjectGroup group{tr("Seams"), {}};
    for (std::size_t i = 0; i < pattern.seams.size(); ++i)
        group.lines.push_back(
            {pattern.seams[i].id, named(pattern.seams[i].name, tr("Seam %1").arg(i + 1)), QStringLiteral("seam"), 0});
    return group;
}

ObjectGroup tacksOf(const Pattern& pattern) {
    ObjectGroup group{tr("Tacks and buttons"), {}};
    for (std::size_t i = 0; i < pattern.tacks.size(); ++i)
        group.lines.push_back(
            {pattern.tacks[i].id, named(pattern.tacks[i].name, tr("Tack %1").arg(i + 1)), QStringLiteral("tack"), 0});
    return group;
}

ObjectGroup fabricsOf(const Pattern& pattern) {
    ObjectGroup group{tr("Fabrics"), {}};
    for (const auto& fabric : pattern.fabrics)
        group.lines.push_back({fabric->id, named(fabric->name, tr("(no name)")), QStringLiteral("fabric"), 0});
    return group;
}

ObjectGroup worldOf(const document::Document& document) {
    ObjectGroup group{tr("World"), {}};
    if (!document.avatarFile.empty())
        group.lines.push_back({AvatarItem{}, QFileInfo(QString::fromStdString(document.avatarFile)).fileName(),
                               QStringLiteral("avatar"), 0});
    group.lines.push_back({SceneItem{}, tr("Scene"), QStringLiteral("scene"), 0});
    return group;
}

} // namespace

std::vector<ObjectGroup> objectsOf(const document::Document& document) {
    std::vector<ObjectGroup> groups{piecesOf(document.pattern), seamsOf(document.pattern)};
    if (!document.pattern.tacks.empty()) groups.push_back(tacksOf(document.pattern));
    groups.push_back(fabricsOf(document.pattern));
    groups.push_back(worldOf(document));
    return groups;
}

ObjectList::ObjectList(Workbench& workbench, QWidget* parent) : QTreeWidget(parent), workbench_(workbench) {
    setObjectName(QStringLiteral("objectList"));
    setHeaderHidden(true);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setFrameShape(QFrame::NoFrame);
    setIndentation(14);
    setUniformRowHeights(true);
    connect(&workbench, &Workbench::documentChanged, this, &ObjectList::refresh);
    connect(&workbench, &Workbench::selectionChanged, this, &ObjectList::showSelection);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &ObjectList::takeSelection);
    refresh();
}

void ObjectList::refresh() {
    std::vector<ObjectGroup> next = objectsOf(workbench_.document());
    if (next == groups_) return;
    groups_ = std::move(next);
    showing_ = true;
    clear();
    lines_.clear();
    for (const ObjectGroup& group : groups_) {
        auto* head = new QTreeWidgetItem(
            this, {tr("%1  %2").arg(group.title).arg(std::ranges::count(group.lines, 0, &ObjectLine::level))});
        head->setFlags(Qt::ItemIsEnabled);
        head->setForeground(0, palette().brush(QPalette::Disabled, QPalette::Text));
        QTreeWidgetItem* above = head;
        for (const ObjectLine& line : group.lines) {
            auto* item = new QTreeWidgetItem(line.level == 0 ? head : above, {line.text});
            item->setIcon(0, QIcon(QStringLiteral(":/icons/%1.svg").arg(line.icon)));
            if (line.level == 0) above = item;
            lines_.emplace_back(item, line.item);
        }
    }
    expandAll();
    showing_ = false;
    showSelection();
}

void ObjectList::showSelection() {
    if (showing_) return;
    showing_ = true;
    QTreeWidgetItem* last = nullptr;
    for (const auto& [line, item] : lines_) {
        const bool selected = contains(workbench_.selection(), item);
        line->setSelected(selected);
        if (selected) last = line;
    }
    if (last) scrollToItem(last);
    showing_ = false;
}

void ObjectList::takeSelection() {
    if (showing_) return;
    Selection selection;
    for (const auto& [line, item] : lines_)
        if (line->isSelected()) selection.push_back(item);
    showing_ = true;
    workbench_.select(selection);
    showing_ = false;
}

} // namespace toile::ui
