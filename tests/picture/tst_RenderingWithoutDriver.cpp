// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/RenderPicture.h"

#include <QTest>

using namespace toile;
using namespace toile::picture;

/// A program of its own, because a process looks for its graphics driver once.
class tst_RenderingWithoutDriver : public QObject {
    Q_OBJECT
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

int main(int argc, char** argv) {
    qputenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");
    tst_RenderingWithoutDriver test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_RenderingWithoutDriver.moc"
