// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/RenderPicture.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using namespace toile::picture;

/// A test of its own, because a process looks for its graphics driver once.
class tst_RenderingWithoutDriver : public QObject {
    Q_OBJECT
public:
    static void initMain() { qputenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"); }
private slots:
    void anErrorSaysWhatIsMissing();
    void askingAgainIsAnErrorAgain();
};

void tst_RenderingWithoutDriver::anErrorSaysWhatIsMissing() {
    const auto image = renderPicture({}, Camera{}, 100, 100);
    QVERIFY(!image);
    QCOMPARE(image.error().code, ErrorCode::unsupported);
    QVERIFY(image.error().text.find("libgl1-mesa-dri") != std::string::npos);
}

void tst_RenderingWithoutDriver::askingAgainIsAnErrorAgain() {
    QVERIFY(!renderPicture({}, ViewDirection::front, 100, 100));
}

TOILE_TEST(tst_RenderingWithoutDriver)
#include "tst_RenderingWithoutDriver.moc"
