#include "app/window/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <utility>

namespace noonmark {

namespace {

constexpr int noteMs = 12000;
constexpr const char* noteColours = "background: #e4eef7; border-bottom: 1px solid #8fb2d1; color: #15324b;";

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      label_(new QLabel),
      remedy_{new QPushButton, {}},
      other_{new QPushButton, {}},
      leave_(new QTimer(this)) {
    setObjectName(QStringLiteral("messageBar"));
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton;
    close->setText(QStringLiteral("\u2715"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 5, 5);
    row->addWidget(label_, 1);
    add(remedy_, "remedy", *row);
    add(other_, "otherRemedy", *row);
    row->addWidget(close, 0, Qt::AlignTop);
    leave_->setSingleShot(true);
    leave_->setInterval(noteMs);
    connect(leave_, &QTimer::timeout, this, &QWidget::hide);
    hide();
}

void MessageBar::showError(const Error& error) {
    show(QString::fromStdString(error.text()),
         "background: #fbe4df; border-bottom: 1px solid #d9806c; color: #5c1606;");
}

void MessageBar::add(Remedy& remedy, const char* name, QHBoxLayout& row) {
    remedy.button->setObjectName(QString::fromLatin1(name));
    row.addWidget(remedy.button, 0, Qt::AlignTop);
    connect(remedy.button, &QPushButton::clicked, this, [this, &remedy] {
        hide();
        if (const auto chosen = std::exchange(remedy.chosen, nullptr)) chosen();
    });
}

void MessageBar::offer(Remedy& remedy, const QString& text, std::function<void()> done) {
    remedy.chosen = std::move(done);
    remedy.button->setText(text);
    remedy.button->show();
}

void MessageBar::offer(const QString& remedy, std::function<void()> done) {
    offer(remedy_, remedy, std::move(done));
}

void MessageBar::offerToo(const QString& remedy, std::function<void()> done) {
    offer(other_, remedy, std::move(done));
}

void MessageBar::showNote(const QString& text) {
    show(text, noteColours);
    leave_->start();
}

void MessageBar::showHelp(const QString& text) { show(text, noteColours); }

void MessageBar::dismiss() {
    if (remedy_.button->isHidden()) hide();
}

QString MessageBar::text() const { return isHidden() ? QString() : label_->text(); }

void MessageBar::show(const QString& text, const char* colours) {
    setStyleSheet(QStringLiteral("#messageBar { %1 } #messageBar QLabel { border: none; }")
                      .arg(QLatin1String(colours)));
    leave_->stop();
    label_->setText(text);
    for (const Remedy* remedy : {&remedy_, &other_}) remedy->button->hide();
    QFrame::show();
}

}  // namespace noonmark
