#include "app/gui/base/widgets/buttons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace noonmark {

QPushButton* pushButton(const QString& text, const char* name, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(tip);
    return button;
}

QWidget* widgetRow(std::initializer_list<QWidget*> widgets, int stretch) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : widgets) line->addWidget(widget, widget == *widgets.begin() ? stretch : 0);
    return row;
}

QLabel* wrappedLabel(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

namespace {

constexpr int cornerPx = 8;
constexpr int marginPx = 8;

// A name of a file has no spaces: it may break after its dots, dashes and underscores.
QString breakable(QString text) {
    for (const QChar sign : {u'.', u'-', u'_', u'/'}) text.replace(sign, QString(sign) + QChar(0x200b));
    return text;
}

QLabel* textLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    // It takes the width that is there, and wraps.
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    label->setSizePolicy(policy);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    return label;
}

QFont bold(QFont font) {
    font.setBold(true);
    return font;
}

}  // namespace

CardButton::CardButton(const QPixmap& picture, const QString& title, const QString& about, const char* name)
    : picture_(new QLabel), title_(textLabel(breakable(title))), about_(textLabel(breakable(about))) {
    setObjectName(QString::fromLatin1(name));
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(about);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    picture_->setPixmap(picture);
    picture_->setAttribute(Qt::WA_TransparentForMouseEvents);
    title_->setFont(bold(title_->font()));
    auto* texts = new QVBoxLayout;
    texts->setSpacing(0);
    texts->addWidget(title_);
    texts->addWidget(about_);
    texts->addStretch(1);
    about_->setVisible(!about.isEmpty());
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(marginPx, marginPx, marginPx, marginPx);
    row->setSpacing(marginPx);
    row->addWidget(picture_, 0, Qt::AlignVCenter);
    row->addLayout(texts, 1);
    paintTexts();
}

void CardButton::paintTexts() {
    const bool quiet = !isEnabled();
    title_->setForegroundRole(quiet ? QPalette::PlaceholderText : QPalette::WindowText);
    about_->setForegroundRole(QPalette::PlaceholderText);
}

void CardButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool marked = isChecked() || hasFocus() || (underMouse() && isEnabled());
    QColor line = palette().color(marked ? QPalette::Highlight : QPalette::Mid);
    QColor fill = palette().color(QPalette::Base);
    if (isChecked() || isDown()) {
        const QColor accent = palette().color(QPalette::Highlight);
        fill = QColor((fill.red() * 5 + accent.red()) / 6, (fill.green() * 5 + accent.green()) / 6,
                      (fill.blue() * 5 + accent.blue()) / 6);
    }
    painter.setPen(QPen(line, hasFocus() || isChecked() ? 2 : 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), cornerPx, cornerPx);
}

void CardButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
    QAbstractButton::keyPressEvent(event);
}

void CardButton::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange) paintTexts();
    QAbstractButton::changeEvent(event);
}

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
