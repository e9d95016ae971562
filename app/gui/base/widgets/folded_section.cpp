#include "app/gui/base/widgets/folded_section.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace noonmark {

FoldedSection::FoldedSection(const QString& title, const char* name, QWidget* content, QWidget* parent)
    : QWidget(parent), heading_(new QToolButton), content_(content) {
    heading_->setObjectName(QString::fromLatin1(name));
    heading_->setText(title);
    heading_->setCheckable(true);
    heading_->setAutoRaise(true);
    heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(heading_);
    column->addWidget(content_);
    connect(heading_, &QToolButton::toggled, this, [this](bool open) {
        heading_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        content_->setVisible(open);
    });
    heading_->setArrowType(Qt::RightArrow);
    content_->hide();
}

void FoldedSection::setFolded(bool folded) { heading_->setChecked(!folded); }

bool FoldedSection::folded() const { return !heading_->isChecked(); }

}  // namespace noonmark
