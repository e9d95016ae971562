#include "app/report/maps/write_png.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QImageReader>

namespace noonmark {
namespace {

QImage checkered() {
    QImage picture(7, 5, QImage::Format_RGB32);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) picture.setPixel(x, y, qRgb(30 * x, 40 * y, (x + y) % 2 * 255));
    return picture;
}

// A disk on which `left` more bytes fit.
class NearlyFullDevice : public QIODevice {
public:
    explicit NearlyFullDevice(qint64 left) : left_(left) { open(QIODevice::WriteOnly); }

protected:
    qint64 readData(char*, qint64) override { return -1; }
    qint64 writeData(const char*, qint64 size) override {
        if (size > left_) return -1;
        left_ -= size;
        return size;
    }

private:
    qint64 left_;
};

TEST(WritePng, KeepsEveryPixelAndTheTags) {
    QBuffer file;
    file.open(QIODevice::ReadWrite);
    const FileTags tags{{"noonmark_program", "Noonmark 0.1.0"}, {"noonmark_region", "Parc Monceau, été"}};
    ASSERT_TRUE(writePng(checkered(), tags, file));
    file.seek(0);
    const QImage read = QImageReader(&file, "png").read();
    EXPECT_EQ(read.convertToFormat(QImage::Format_RGB32), checkered());
    EXPECT_EQ(read.text("noonmark_program"), QString("Noonmark 0.1.0"));
    EXPECT_EQ(read.text("noonmark_region"), QString::fromUtf8("Parc Monceau, été"));
}

TEST(WritePng, SaysThatTheDiskIsFull) {
    QBuffer whole;
    whole.open(QIODevice::WriteOnly);
    ASSERT_TRUE(writePng(checkered(), {}, whole));
    for (qint64 left = 0; left < whole.size(); left += 7) {
        NearlyFullDevice device(left);
        EXPECT_FALSE(writePng(checkered(), {}, device)) << left << " bytes";
    }
}

TEST(WritePng, RefusesAnEmptyPicture) {
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    EXPECT_FALSE(writePng(QImage(), {}, file));
}

}  // namespace
}  // namespace noonmark
