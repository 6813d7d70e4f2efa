// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"
#include "ui/window/MainWindow.h"
#include "ui/window/Theme.h"
#include "ui/workbench/RealParts.h"

#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <numbers>

namespace toile::ui {

/// Before the first window: settings stay away from the user's, and from those of tests that run at the same time.
inline void prepareApplication() {
    static const QTemporaryDir settings;
    QStandardPaths::setTestModeEnabled(true);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QApplication::setOrganizationName(QStringLiteral("toile-tests"));
    applyTheme(*qApp);
}

/// A window as the program makes it, and a hand on its mouse and keys.
struct Bench {
    Workbench workbench;
    MainWindow window;

    explicit Bench(const QString& recoveryFolder = {})
        : workbench(realParts(recoveryFolder)),
          window(workbench,
                 {writeDrapeOf, {qEnvironmentVariable("TOILE_SOURCE_DIR") + QStringLiteral("/samples")}, {}}) {
        window.resize(1400, 860);
        window.show();
        (void)QTest::qWaitForWindowExposed(&window);
        look({0.5, 0.3}, 500);
    }

    // -- the pattern
    void look(Vec2 centre, double scale) { window.patternView().setView({centre, scale, window.patternView().size()}); }
    QPoint pixel(Vec2 at) { return window.patternView().view().toScreen(at).toPoint(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QApplication::setActiveWindow(&window); // without a window manager nobody else does, and only it gets shortcuts
        QTest::keyClick(&window, key, modifiers);
    }
    void toolKey(Qt::Key key) {
        QApplication::setActiveWindow(&window); // Delete is a shortcut
        QTest::keyClick(&window.patternView(), key);
    }
    void point(Vec2 at) { QTest::mouseMove(&window.patternView(), pixel(at)); }
    void click(Vec2 at, Qt::KeyboardModifiers modifiers = {}) {
        point(at);
        QTest::mouseClick(&window.patternView(), Qt::LeftButton, modifiers, pixel(at));
    }
    void drag(Vec2 from, Vec2 to, const std::function<void()>& beforeTheEnd = {}) {
        std::vector<QPoint> way;
        for (int i = 0; i <= 8; ++i) way.push_back(pixel(lerp(from, to, i / 8.0)));
        drag(window.patternView(), way, {}, beforeTheEnd);
    }

    // -- space
    QPoint pixelOf(const Vec3& point) {
        const View3D& view = window.view3D();
        const Vec2 seen = worldToScreen(view.camera(), view.viewport(), point)->pixel;
        return {qRound(seen.x), qRound(seen.y)};
    }
    /// Pulls the gizmo's arrow along an axis of the world (0 = x) by whole centimetres [m].
    void pullArrow(int axis, double by, const std::function<void()>& beforeTheEnd = {}) {
        const PlacementGizmo gizmo = *window.view3D().gizmo();
        Vec3 along;
        along[axis] = 1;
        const Vec3 from = gizmo.pivot() + along * (60 * pixelSize(gizmo)); // past the middle of the arrow
        std::vector<QPoint> way;
        for (int i = 0; i <= 8; ++i) way.push_back(pixelOf(from + along * (by * i / 8)));
        drag(window.view3D(), way, Qt::ControlModifier, beforeTheEnd);
    }
    /// Turns the gizmo's upright ring by multiples of 5° [rad]; seen from above.
    void turnRing(double by) {
        const PlacementGizmo gizmo = *window.view3D().gizmo();
        const double radius = 70 * pixelSize(gizmo), start = std::numbers::pi / 4; // between the arrows
        std::vector<QPoint> way;
        for (int i = 0; i <= 24; ++i) {
            const double angle = start + by * i / 24;
            way.push_back(pixelOf(gizmo.pivot() + Vec3{std::sin(angle), 0, std::cos(angle)} * radius));
        }
        drag(window.view3D(), way, Qt::ControlModifier);
    }

    // -- dialogs
    /// What is done with the next dialog when it has come up.
    template <class Dialog>
    static void whenAsked(std::function<void(Dialog&)> answer) {
        QTimer::singleShot(0, [answer = std::move(answer)] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            QVERIFY2(dialog, "no such dialog has come up");
            answer(*dialog);
        });
    }
    /// The next dialog asks for a file and gets this one, of this kind where the name does not say it.
    static void nextFile(const QString& path, const QString& kind = {}) {
        whenAsked<QFileDialog>([path, kind](QFileDialog& dialog) {
            if (!kind.isEmpty()) dialog.selectNameFilter(kind);
            auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            name->setText(path);
            QTest::keyClick(name, Qt::Key_Return);
        });
    }

    /// Keeps a picture of the window where TOILE_PICTURES names a folder: to be looked at.
    void picture(const char* name) {
        const QString folder = qEnvironmentVariable("TOILE_PICTURES");
        if (folder.isEmpty()) return;
        QTest::qWait(300);
        QVERIFY(window.grab().save(folder + QLatin1Char('/') + QLatin1String(name)));
    }
    const pattern::Pattern& pattern() { return workbench.document().pattern; }
    template <class Widget>
    Widget* find(const char* name) {
        return window.findChild<Widget*>(QLatin1String(name));
    }
    QAction* action(const char* id) { return window.actions()[QLatin1String(id)]; }

private:
    double pixelSize(const PlacementGizmo& gizmo) {
        return picture::pixelSize(window.view3D().camera(), window.view3D().viewport(), gizmo.pivot());
    }
    /// QTest::mouseMove does not say that a button is held.
    static void drag(QWidget& view, const std::vector<QPoint>& way, Qt::KeyboardModifiers modifiers,
                     const std::function<void()>& beforeTheEnd = {}) {
        QTest::mouseMove(&view, way.front());
        QTest::mousePress(&view, Qt::LeftButton, modifiers, way.front());
        for (const QPoint at : way) {
            QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(&view, &event);
        }
        if (beforeTheEnd) beforeTheEnd();
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, way.back());
    }
};

} // namespace toile::ui
