#pragma once

#include <QWidget>

#include "app/report/book/book.h"
#include "app/report/book/paper.h"

class QSettings;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace noonmark {

/// The paper of sheets that was last chosen, in a dialog of sheets or in the preferences; at first that of
/// the country, upright.
PageSetup readPageSetup(const QSettings& settings);
void savePageSetup(const PageSetup& setup, QSettings& settings);

class FieldRows;

/// Paper, scale and units of sheets, and the texts of their title block.
class SheetForm final : public QWidget {
    Q_OBJECT
public:
    explicit SheetForm(QWidget* parent = nullptr);

    /// Whether the sheets may be many, so that what they hold is asked for.
    void offerExtent(bool offered);

    void show(const BookSettings& settings);  ///< without a signal
    /// The fields' values; an empty date stays empty.
    [[nodiscard]] BookSettings settings() const;

    /// Takes the logo from a file, as the button does. Error: of readLogo() and validate().
    Result<void> takeLogo(const QString& file);

Q_SIGNALS:
    void edited();
    void failed(noonmark::Error error);

private:
    void makePaper(QFormLayout& form);
    void makeTitleBlock(QFormLayout& form);
    QWidget* makeLogo();
    QComboBox* addList(QFormLayout& form, const QString& label, const char* name, const QString& tip);
    void askForLogo();
    void showLogo();
    void showToday();

    QFormLayout* page_;  // the rows of the paper
    QComboBox *paper_, *orientation_, *scale_, *units_;
    FieldRows* title_;
    FieldRows* book_;
    FieldRows* extent_;
    QLabel* logoPicture_;
    QPushButton* removeLogo_;
    std::string logo_;  // the bytes of the picture
};

}  // namespace noonmark
