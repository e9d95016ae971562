#include "app/gui/tools/photograph/tile_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace noonmark {

TileDialog::TileDialog(const TileRange& range, QWidget* parent)
    : QDialog(parent),
      range_(range),
      address_(new QLineEdit),
      attribution_(new QLineEdit),
      about_(new QLabel),
      progress_(new QProgressBar) {
    setWindowTitle(tr("Aerial photograph from tiles"));
    setMinimumWidth(480);
    new QVBoxLayout(this);
    addFields();
    addButtons();
    connect(&fetch_, &TileFetch::progressed, progress_, [this](int done, int all) {
        progress_->setMaximum(all);
        progress_->setValue(done);
    });
    connect(&fetch_, &TileFetch::finished, this, &QDialog::accept);
    connect(&fetch_, &TileFetch::failed, this, &TileDialog::showFailure);
    follow();
}

void TileDialog::addFields() {
    address_->setObjectName(QStringLiteral("tileAddress"));
    address_->setPlaceholderText(QStringLiteral("https://tiles.example.org/{z}/{x}/{y}.png"));
    address_->setToolTip(tr("Address of the tiles, with {z} for the zoom, {x} and {y} for the tile"));
    attribution_->setObjectName(QStringLiteral("tileAttribution"));
    attribution_->setMaxLength(300);
    attribution_->setToolTip(
        tr("Whose tiles they are, as their owner asks for; printed wherever they are drawn"));
    about_->setWordWrap(true);
    about_->setText(tr("Nothing is fetched before the button is pressed. Tiles of zoom %1: %2. Ask their "
                       "owner whether you may store and print them.")
                        .arg(range_.zoom)
                        .arg(range_.count()));
    progress_->setVisible(false);
    auto* form = new QFormLayout;
    form->addRow(tr("Address"), address_);
    form->addRow(tr("Attribution"), attribution_);
    form->addRow(about_);
    form->addRow(progress_);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
    for (QLineEdit* field : {address_, attribution_})
        connect(field, &QLineEdit::textChanged, this, &TileDialog::follow);
}

void TileDialog::addButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    begin_ = buttons->addButton(tr("Fetch tiles"), QDialogButtonBox::ActionRole);
    begin_->setObjectName(QStringLiteral("tileFetch"));
    begin_->setToolTip(tr("Fetches the tiles over the city from this address"));
    connect(begin_, &QPushButton::clicked, this, &TileDialog::begin);
    connect(buttons, &QDialogButtonBox::rejected, this, &TileDialog::reject);
    layout()->addWidget(buttons);
}

QString TileDialog::attribution() const { return attribution_->text().trimmed(); }

void TileDialog::follow() {
    begin_->setEnabled(!fetch_.busy() && !attribution().isEmpty() &&
                       checkTemplate(address_->text().trimmed()));
}

void TileDialog::begin() {
    progress_->setVisible(true);
    progress_->setValue(0);
    fetch_.start(address_->text().trimmed(), range_);
    follow();
}

void TileDialog::reject() {
    if (!fetch_.busy()) return QDialog::reject();
    fetch_.cancel();
    progress_->setVisible(false);
    follow();
}

void TileDialog::showFailure(const Error& error) {
    progress_->setVisible(false);
    about_->setText(QString::fromStdString(error.text()));
    follow();
}

}  // namespace noonmark
