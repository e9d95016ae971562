#include "app/gui/tools/photograph/photograph_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

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

PhotographDialog::PhotographDialog(const std::optional<GroundPictureFile>& picture, Ask ask, QWidget* parent)
    : QDialog(parent),
      picture_(picture.value_or(GroundPictureFile{})),
      ask_(std::move(ask)),
      file_(new QLabel),
      attribution_(new QLineEdit),
      opacity_(new QSpinBox),
      shown_(new QCheckBox(tr("Draw it"))) {
    setWindowTitle(tr("Aerial photograph"));
    new QVBoxLayout(this);
    addFields();
    addButtons();
    showFile();
}

void PhotographDialog::addFields() {
    attribution_->setObjectName(QStringLiteral("photographAttribution"));
    attribution_->setMaxLength(300);
    attribution_->setText(QString::fromStdString(picture_.attribution));
    attribution_->setPlaceholderText(tr("(c) owner of the photograph, year"));
    attribution_->setToolTip(tr("Whose photograph it is; printed on maps, sheets and pictures that show it"));
    opacity_->setObjectName(QStringLiteral("photographOpacity"));
    opacity_->setRange(0, 100);
    opacity_->setSuffix(tr(" %"));
    opacity_->setValue(int(std::lround(picture_.opacity * 100)));
    opacity_->setToolTip(tr("How much it covers streets, parks and water below it"));
    shown_->setObjectName(QStringLiteral("photographShown"));
    shown_->setChecked(picture_.shown);
    shown_->setToolTip(tr("On the ground of the view, on maps and on sheets"));
    auto* form = new QFormLayout;
    form->addRow(tr("File"), file_);
    form->addRow(tr("Attribution"), attribution_);
    form->addRow(tr("Opacity"), opacity_);
    form->addRow(shown_);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void PhotographDialog::addButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* choose = buttons->addButton(tr("Choose file..."), QDialogButtonBox::ActionRole);
    choose->setObjectName(QStringLiteral("photographChoose"));
    choose->setToolTip(tr("A GeoTIFF or Erdas Imagine file with its position, of 8 bits per colour"));
    QPushButton* tiles = buttons->addButton(tr("From tiles..."), QDialogButtonBox::ActionRole);
    tiles->setObjectName(QStringLiteral("photographTiles"));
    tiles->setToolTip(tr("Fetches tiles of the web's map scheme from an address that you state"));
    connect(tiles, &QPushButton::clicked, this, [this] { done(tilesRequested); });
    QPushButton* remove = buttons->addButton(tr("Remove"), QDialogButtonBox::ActionRole);
    remove->setObjectName(QStringLiteral("photographRemove"));
    remove->setToolTip(tr("Takes the photograph out of the project; its file stays"));
    connect(choose, &QPushButton::clicked, this, &PhotographDialog::chooseFile);
    connect(remove, &QPushButton::clicked, this, &PhotographDialog::removeFile);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout()->addWidget(buttons);
}

void PhotographDialog::chooseFile() {
    const QString file = ask_();
    if (file.isEmpty()) return;
    picture_.path = file.toStdString();
    picture_.sha256.clear();
    showFile();
}

void PhotographDialog::removeFile() {
    picture_.path.clear();
    showFile();
}

void PhotographDialog::showFile() {
    const bool none = picture_.path.empty();
    file_->setText(none ? tr("none") : QString::fromStdString(picture_.path.filename().string()));
    file_->setToolTip(QString::fromStdString(picture_.path.string()));
    for (QWidget* field : {static_cast<QWidget*>(attribution_), static_cast<QWidget*>(opacity_),
                           static_cast<QWidget*>(shown_)})
        field->setEnabled(!none);
}

std::optional<GroundPictureFile> PhotographDialog::picture() const {
    if (picture_.path.empty()) return std::nullopt;
    return GroundPictureFile{picture_.path, picture_.sha256, attribution_->text().trimmed().toStdString(),
                             opacity_->value() / 100.0, shown_->isChecked()};
}

}  // namespace noonmark
