#include "app/report/maps/write_png.h"

namespace noonmark {

bool writePng(QImage picture, const FileTags& tags, QIODevice& device) {
    for (const auto& [name, text] : tags)
        picture.setText(QString::fromStdString(name), QString::fromStdString(text));
    constexpr int quickest = 80;  // zlib's level 1: a map is a seventh larger
    return picture.save(&device, "PNG", quickest);
}

}  // namespace noonmark
