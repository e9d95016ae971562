#pragma once

#include <QDialog>
#include <QStringList>

#include "core/io/read_city.h"

class QLabel;

namespace noonmark {

class ReadingForm;

/// A dialog for the reading settings of files that do not state everything. It is not modal.
class OpenOptions final : public QDialog {
    Q_OBJECT
public:
    explicit OpenOptions(QWidget* parent = nullptr);

    /// Shows the dialog for these files, with the fields set to `settings`.
    void ask(const QStringList& files, const ReadSettings& settings);
    void setMiddle(std::optional<LonLat> middle);  ///< of the open city

    [[nodiscard]] QStringList files() const { return files_; }

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings settings);

private:
    QStringList files_;
    QLabel* names_;
    ReadingForm* form_;
};

}  // namespace noonmark
