#include "app/gui/docks/search/search_field.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QStandardItemModel>
#include <utility>

namespace noonmark {

namespace {

constexpr int listWidth = 420;  // pixels: names are longer than the field

}  // namespace

SearchField::SearchField(QWidget* parent)
    : QLineEdit(parent), model_(new QStandardItemModel(this)), completer_(new QCompleter(model_, this)) {
    setObjectName(QStringLiteral("search"));
    setPlaceholderText(tr("Find (Ctrl+F)"));
    setToolTip(
        tr("A building by name or id, a street, a place, a lot, or a position such as 40.7536, -73.9832"));
    setClearButtonEnabled(true);
    setMinimumWidth(220);
    completer_->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    setCompleter(completer_);
    completer_->popup()->setMinimumWidth(listWidth);
    connect(this, &QLineEdit::textEdited, this, &SearchField::search);
    connect(completer_, qOverload<const QModelIndex&>(&QCompleter::activated), this,
            [this](const QModelIndex& index) { take(std::size_t(index.row())); });
    connect(this, &QLineEdit::returnPressed, this, &SearchField::takeFirst);
}

void SearchField::setIndex(MakeIndex make) {
    makeIndex_ = std::move(make);
    shown_.clear();
    model_->clear();
}

void SearchField::begin() {
    setFocus(Qt::ShortcutFocusReason);
    selectAll();
}

void SearchField::search(const QString& text) {
    if (makeIndex_) index_ = std::exchange(makeIndex_, nullptr)();
    shown_ = index_.find(text);
    model_->clear();
    for (const Found& found : shown_)
        model_->appendRow(new QStandardItem(QStringLiteral("%1 (%2)").arg(found.title, found.about)));
}

void SearchField::take(std::size_t place) {
    if (place >= shown_.size()) return;
    setText(shown_[place].title);
    Q_EMIT found(shown_[place]);
}

// A choice in the list has been taken already.
void SearchField::takeFirst() {
    if (completer_->popup()->currentIndex().isValid()) return;
    search(text());
    if (shown_.empty()) return Q_EMIT nothingFound(text());
    completer_->popup()->hide();
    take(0);
}

}  // namespace noonmark
