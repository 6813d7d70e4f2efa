// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "WindowFixture.h"
#include "core/document/DocumentEdits.h"
#include "tests/Suite.h"
#include "ui/window/MotionDialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolTip>

#include <fstream>

using namespace toile;
using namespace toile::ui;

/// The avatar that moves, from the window's menus, keys and dialogs.
class tst_AvatarMotion : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        prepareApplication();
        QSettings().clear();
    }
    void whatCannotBeSaysWhyInTheMenu();
    void theAvatarGoesThroughPosesAndBack();
    void theDialogSaysWhatIsInAFolder();
    void whatIsNoMotionOfTheAvatarIsTold();
};

namespace {

/// A table of 1 × 1 m, 0.5 m high, that is lifted.
void writeTable(const QString& path, double lift) {
    std::ofstream out(path.toStdString());
    for (const double y : {0.0, 0.5})
        for (const double z : {-0.5, 0.5})
            for (const double x : {-0.5, 0.5}) out << "v " << x << ' ' << y + lift << ' ' << z << '\n';
    for (const char* face :
         {"1 2 4", "1 4 3", "5 8 6", "5 7 8", "1 6 2", "1 5 6", "3 4 8", "3 8 7", "1 3 7", "1 7 5", "2 6 8", "2 8 4"})
        out << "f " << face << '\n';
}

/// A cloth that falls on a table, and the poses of the table that rises by 100 mm.
struct Laid : Bench {
    QTemporaryDir folder;
    QString poses = folder.filePath(QStringLiteral("poses"));

    Laid() {
        writeTable(folder.filePath(QStringLiteral("table.obj")), 0);
        QDir().mkpath(poses);
        for (int i = 0; i <= 2; ++i) writeTable(QStringLiteral("%1/table-%2.obj").arg(poses).arg(i), 0.05 * i);
        document::Document document = withRectangle(workbench.document(), "Cloth", {0, 0}, 0.3, 0.3);
        pattern::Piece cloth = *document.pattern.pieces[0];
        cloth.fabric = document.pattern.fabrics[0]->id;
        cloth.spacing = 0.03;
        cloth.placement = pattern::Placement{};
        cloth.placement->transform = {
            .axisX = {1, 0, 0}, .axisY = {0, 0, -1}, .axisZ = {0, 1, 0}, .origin = {0, 0.51, 0}};
        document.pattern.pieces[0] = Shared<pattern::Piece>(std::move(cloth));
        document = document::withAvatar(document, folder.filePath(QStringLiteral("table.obj")).toStdString());
        workbench.startFrom(std::move(document), {}, false);
    }
    bool waitFor(const std::function<bool()>& wanted) {
        return QTest::qWaitFor([&] { return workbench.frame() && workbench.body() && wanted(); }, 30000);
    }
    [[nodiscard]] bool stands() const { return !workbench.frame()->bodyMoves && workbench.frame()->atRest; }
    [[nodiscard]] double height() const { return workbench.frame()->positions[0].y; }
    [[nodiscard]] QString told() { return find<QLabel>("statusMessage")->text(); }
    /// By the key; the dialog is filled in by hand.
    void moveThrough(const QString& poseFolder, double rate) {
        whenAsked<MotionDialog>([poseFolder, rate, this](MotionDialog& dialog) {
            auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("motionFolder"));
            field->selectAll();
            QTest::keyClicks(field, poseFolder);
            dialog.findChild<QDoubleSpinBox*>(QStringLiteral("motionRate"))->setValue(rate);
            const QString pictures = qEnvironmentVariable("TOILE_PICTURES");
            if (!pictures.isEmpty()) QVERIFY(dialog.grab().save(pictures + QStringLiteral("/motion-dialog.png")));
            QTest::keyClick(field, Qt::Key_Return);
        });
        key(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    }
};

} // namespace

void tst_AvatarMotion::whatCannotBeSaysWhyInTheMenu() {
    Bench bench;
    QAction* move = bench.action("avatar.moveThroughPoses");
    for (const char* id : {"avatar.liftArms", "avatar.moveThroughPoses", "avatar.moveBack"}) {
        QVERIFY2(!bench.action(id)->isEnabled(), id);
        QVERIFY2(bench.action(id)->toolTip().contains("no avatar"), id);
    }
    for (QAction* title : bench.window.menuBar()->actions())
        if (QMenu* menu = title->menu(); menu->actions().contains(move)) {
            menu->popup(bench.window.mapToGlobal(QPoint(50, 50)));
            QVERIFY(QTest::qWaitForWindowExposed(menu));
            const QPoint entry = menu->actionGeometry(move).center();
            QHelpEvent rests(QEvent::ToolTip, entry, menu->mapToGlobal(entry));
            QApplication::sendEvent(menu, &rests);
            QCOMPARE(QToolTip::text(), move->toolTip());
            menu->close();
        }
    QToolTip::hideText();
}

void tst_AvatarMotion::theAvatarGoesThroughPosesAndBack() {
    Laid laid;
    laid.key(Qt::Key_Space);
    QVERIFY(laid.waitFor([&] { return laid.stands(); }));
    QVERIFY(laid.action("avatar.moveThroughPoses")->isEnabled());
    QVERIFY(!laid.action("avatar.moveBack")->isEnabled());
    const double low = laid.height();
    laid.moveThrough(laid.poses, 10);
    QVERIFY(laid.waitFor([&] { return laid.workbench.bodyHasMoved() && laid.stands(); }));
    QVERIFY(std::abs(laid.height() - low - 0.1) < 2e-3);
    QVERIFY(!laid.action("avatar.moveThroughPoses")->isEnabled());
    QVERIFY(laid.action("avatar.moveThroughPoses")->toolTip().contains("move it back first"));
    QVERIFY(!laid.action("avatar.liftArms")->isChecked());
    laid.key(Qt::Key_B, Qt::ControlModifier);
    QVERIFY(laid.waitFor([&] { return !laid.workbench.bodyHasMoved() && laid.stands(); }));
    QVERIFY(std::abs(laid.height() - low) < 2e-3);
    QVERIFY(laid.action("avatar.moveThroughPoses")->isEnabled());
    laid.key(Qt::Key_R, Qt::ControlModifier);
}

void tst_AvatarMotion::theDialogSaysWhatIsInAFolder() {
    const Laid laid;
    QSettings().remove(QStringLiteral("motion"));
    {
        MotionDialog dialog;
        auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("motionFolder"));
        auto* found = dialog.findChild<QLabel*>(QStringLiteral("motionFound"));
        auto* move = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QVERIFY(found->text().isEmpty() && !move->isEnabled());
        field->setText(laid.folder.path()); // one model
        QVERIFY(found->text().contains("two poses at least") && !move->isEnabled());
        field->setText(laid.folder.filePath(QStringLiteral("nowhere")));
        QVERIFY(found->text().contains("cannot be read") && !move->isEnabled());
        field->setText(laid.poses);
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("motionRate"))->setValue(4);
        QCOMPARE(found->text(), QStringLiteral("3 poses in 0.50 s: table-0.obj … table-2.obj"));
        QVERIFY(move->isEnabled());
        QCOMPARE(dialog.step(), 0.25);
        move->click();
    }
    const MotionDialog next;
    QCOMPARE(next.folder(), laid.poses);
    QCOMPARE(next.step(), 0.25);
}

void tst_AvatarMotion::whatIsNoMotionOfTheAvatarIsTold() {
    Laid laid;
    writeTable(laid.poses + QStringLiteral("/another.obj"), 0.3); // the first by its name
    laid.key(Qt::Key_Space);
    QVERIFY(laid.waitFor([&] { return laid.stands(); }));
    laid.moveThrough(laid.poses, 10);
    QVERIFY(laid.waitFor([&] { return laid.told().contains("The first pose must be the avatar as it stands"); }));
    QVERIFY(laid.told().contains("another.obj"));
    QVERIFY(laid.action("avatar.moveThroughPoses")->isEnabled()); // the next try
    QVERIFY(!laid.workbench.bodyHasMoved());
}

TOILE_TEST(tst_AvatarMotion, QApplication)
#include "tst_AvatarMotion.moc"
