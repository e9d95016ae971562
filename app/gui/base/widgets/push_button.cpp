#include "app/gui/base/widgets/push_button.h"

#include <QPushButton>

namespace noonmark {

QPushButton* pushButton(const QString& text, const char* name, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(tip);
    return button;
}

}  // namespace noonmark
