// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/view3d/View3D.h"

#include <QLabel>
#include <QTest>

using namespace toile::ui;

/// A test of its own, because a process looks for its graphics driver once.
class tst_View3DWithoutDriver : public QObject {
    Q_OBJECT
public:
    static void initMain() {
        qputenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
private slots:
    void aMessageStandsInTheViewsPlace();
};

void tst_View3DWithoutDriver::aMessageStandsInTheViewsPlace() {
    View3D view;
    view.resize(400, 300);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTRY_VERIFY(view.findChild<QLabel*>("view3dMessage"));
    const QString text = view.findChild<QLabel*>("view3dMessage")->text();
    QVERIFY(text.contains("libgl1-mesa-dri")); // says what to do
    view.fit();                                // and everything else works
    view.viewTop();
    QTest::mouseClick(&view, Qt::LeftButton);
    QVERIFY(!view.grab().isNull());
}

TOILE_TEST(tst_View3DWithoutDriver, QApplication)
#include "tst_View3DWithoutDriver.moc"
