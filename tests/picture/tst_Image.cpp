// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Image.h"
#include "tests/Suite.h"

#include <QTemporaryDir>
#include <QTest>

#include <png.h>

using namespace toile;
using namespace toile::picture;

namespace {

Image chequers(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x * 20, y * 30, (x + y) % 2 * 255, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    return image;
}

} // namespace

class tst_Image : public QObject {
    Q_OBJECT
private slots:
    void aPngHoldsThePixels();
    void halvingTakesTheMeanOfFour();
    void aFolderThatDoesNotExistIsAnError();
};

void tst_Image::aPngHoldsThePixels() {
    const QTemporaryDir folder;
    const auto path = std::filesystem::path(folder.filePath("picture.png").toStdString());
    const Image image = chequers(7, 5);
    QVERIFY(writePng(path, image));

    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    QVERIFY(png_image_begin_read_from_file(&header, path.c_str()));
    header.format = PNG_FORMAT_RGBA;
    Image read{static_cast<int>(header.width), static_cast<int>(header.height), {}};
    read.rgba.resize(PNG_IMAGE_SIZE(header));
    QVERIFY(png_image_finish_read(&header, nullptr, read.rgba.data(), 0, nullptr));
    QVERIFY(read == image);
}

void tst_Image::halvingTakesTheMeanOfFour() {
    const Image half = halved(chequers(4, 2));
    QCOMPARE(half.width, 2);
    QCOMPARE(half.height, 1);
    const std::vector<std::uint8_t> wanted{10, 15, 128, 255, 50, 15, 128, 255}; // 127.5 is rounded up
    QVERIFY(half.rgba == wanted);
}

void tst_Image::aFolderThatDoesNotExistIsAnError() {
    const auto written = writePng("/no/such/folder/picture.png", chequers(2, 2));
    QVERIFY(!written);
    QVERIFY(!written.error().text.empty());
}

TOILE_TEST(tst_Image)
#include "tst_Image.moc"
