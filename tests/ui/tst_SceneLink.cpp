// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::ui;

class tst_SceneLink : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void theViewGoesOnWhenThePieceThatIsDraggedHasGone();
};

void tst_SceneLink::theViewGoesOnWhenThePieceThatIsDraggedHasGone() {
    Bench bench;
    const View3D& view = bench.window.view3D();
    bench.key(Qt::Key_D, Qt::ShiftModifier);
    for (const Vec2 at : {Vec2{0.4, 0.2}, {0.6, 0.2}, {0.6, 0.4}}) bench.click(at);
    bench.toolKey(Qt::Key_Return);
    QTRY_VERIFY(view.gizmo()); // of the piece just drawn
    bench.pullArrow(0, 0.1, [&] { bench.workbench.undo(); });
    QTRY_VERIFY(!view.scene().frame && !view.gizmo());
    bench.workbench.redo();
    QTRY_VERIFY(view.scene().frame);
    bench.workbench.select({bench.pattern().pieces[0]->id});
    QTRY_VERIFY(view.gizmo());
}

TOILE_TEST(tst_SceneLink, QApplication)
#include "tst_SceneLink.moc"
