#include "app/report/maps/write_png.h"

namespace noonmark {

bool writePng(QImage picture, const FileTags& tags, QIODevice& device) {
    for (const auto& [name, text] : tags)
        picture.setText(QString::fromStdString(name), QString::fromStdString(text));
    return picture.save(&device, "PNG");
}

}  // namespace noonmark
