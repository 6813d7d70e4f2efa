// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowFixture.h"
#include "tests/Suite.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>

#include <random>

using namespace toile;
using namespace toile::ui;

/// Whatever is done, in whatever order, while it sews: nothing breaks, and undo leads back to where it began.
class tst_RandomEdits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void fiveHundredEditsWhileItSews_data();
    void fiveHundredEditsWhileItSews();
};

namespace {

constexpr int wantedEdits = 500;

/// Uses the window without thinking.
struct Monkey {
    Bench& bench;
    std::mt19937 random;
    int edits = 0;

    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random); }
    template <class List>
    auto& oneOf(List& list) {
        return list[random() % std::size(list)];
    }

    /// Mostly where something is: a vertex, an edge or the inside of a piece.
    Vec2 somewhere() {
        const FlatPattern& flat = bench.workbench.flat();
        if (flat.pieces.empty() || random() % 8 == 0) return {between(-0.2, 1.4), between(-0.3, 0.9)};
        const FlatPiece& piece = oneOf(flat.pieces);
        const geometry::Polygon& outline = piece.outline.polygon;
        const Vec2 corner = oneOf(outline);
        switch (random() % 3) {
        case 0: return corner;
        case 1: return lerp(corner, oneOf(outline), 0.5);
        default: return lerp(corner, (boundsOf(piece).low + boundsOf(piece).high) * 0.5, between(0, 1));
        }
    }
    void useATool() {
        static const char* tools[] = {"tool.transform",    "tool.editPoints", "tool.drawPiece",   "tool.internalLine",
                                      "tool.paintPolygon", "tool.paintBrush", "tool.sewSegments", "tool.sewFree",
                                      "tool.editSewing",   "tool.notch",      "tool.dart",        "tool.hole"};
        bench.action(oneOf(tools))->trigger();
        for (int i = static_cast<int>(random() % 5); i >= 0; --i) {
            if (random() % 3 == 0) bench.drag(somewhere(), somewhere());
            else bench.click(somewhere(), random() % 4 == 0 ? Qt::ShiftModifier : Qt::NoModifier);
        }
        static const Qt::Key keys[] = {Qt::Key_Return, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Backspace,
                                       Qt::Key_Delete};
        if (random() % 3 == 0) bench.toolKey(oneOf(keys));
    }
    void triggerAnAction() {
        static const char* actions[] = {"edit.undo",        "edit.redo",        "edit.delete",     "edit.layOut",
                                        "place.front",      "place.back",       "place.left",      "place.right",
                                        "avatar.mannequin", "avatar.remove",    "view.fitAll",     "view.top",
                                        "look.mesh",        "look3d.meshLines", "simulation.step", "simulation.reset"};
        bench.action(oneOf(actions))->trigger();
    }
    void changeAProperty() {
        auto* sheet = bench.find<QWidget>("propertyEditor");
        auto widgets = sheet->findChildren<QWidget*>();
        widgets.removeIf([&](QWidget* widget) {
            return !qobject_cast<QDoubleSpinBox*>(widget) && !qobject_cast<QComboBox*>(widget) &&
                   !qobject_cast<QCheckBox*>(widget) && !qobject_cast<QPushButton*>(widget);
        });
        if (widgets.isEmpty()) return;
        QWidget* widget = oneOf(widgets);
        if (auto* number = qobject_cast<QDoubleSpinBox*>(widget))
            number->setValue(number->objectName() == QLatin1String("spacing")
                                 ? between(10, 40) // finer would only take long
                                 : number->value() * between(0.8, 1.25) + between(-1, 1));
        else if (auto* choice = qobject_cast<QComboBox*>(widget); choice && choice->count() > 0)
            Q_EMIT choice->activated(static_cast<int>(random() % static_cast<unsigned>(choice->count())));
        else if (auto* flag = qobject_cast<QCheckBox*>(widget)) flag->toggle();
        else if (auto* button = qobject_cast<QPushButton*>(widget)) button->click();
    }
    void drawAPiece() { // so that it does not run out of cloth
        bench.action("tool.drawPiece")->trigger();
        const Vec2 at{between(0, 1), between(0, 0.5)};
        for (const Vec2 corner : {Vec2{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.25}}) bench.click(at + corner);
        bench.toolKey(Qt::Key_Return);
    }
    void doSomething() {
        switch (random() % 8) {
        case 0: return triggerAnAction();
        case 1:
        case 2: return changeAProperty();
        case 3:
            if (bench.pattern().pieces.size() < 4) return drawAPiece();
            [[fallthrough]];
        default: return useATool();
        }
    }
};

} // namespace

void tst_RandomEdits::fiveHundredEditsWhileItSews_data() {
    QTest::addColumn<unsigned>("seed");
    for (const unsigned seed : {1U, 2U}) QTest::addRow("seed %u", seed) << seed;
}

void tst_RandomEdits::fiveHundredEditsWhileItSews() {
    QFETCH(unsigned, seed);
    Bench bench;
    QVERIFY(bench.workbench.openCopy(qEnvironmentVariable("TOILE_SOURCE_DIR") +
                                     QStringLiteral("/samples/two-squares.toile")));
    const document::Document start = bench.workbench.document();
    Monkey monkey{bench, std::mt19937(seed)};
    connect(&bench.workbench, &Workbench::documentChanged, &bench.window, [&] { ++monkey.edits; });
    for (int i = 0; i < 20 * wantedEdits && monkey.edits < wantedEdits; ++i) {
        if (!bench.workbench.isPlaying() && i % 10 == 0) bench.key(Qt::Key_Space);
        monkey.doSomething();
        if (i % 3 == 0) QTest::qWait(5); // lets meshes and frames arrive between the edits
    }
    QVERIFY2(monkey.edits >= wantedEdits, qPrintable(QString::number(monkey.edits)));
    while (bench.workbench.history().canUndo()) bench.workbench.undo();
    QVERIFY(bench.workbench.document() == start);
    bench.workbench.pause();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.workbench.isFollowing(), 60000); // the last scene arrives
    QVERIFY(bench.workbench.frame() && !bench.workbench.frame()->positions.empty());
}

TOILE_TEST(tst_RandomEdits, QApplication)
#include "tst_RandomEdits.moc"
