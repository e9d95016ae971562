#pragma once

#include <QStringList>

#include "core/io/read_city.h"

class QSettings;

namespace noonmark {

/// What was opened lately, newest first: paths, several joined by newlines when opened together, or samples;
/// each with how it was read last.
class RecentFiles {
public:
    static constexpr int most = 10;
    explicit RecentFiles(QSettings& settings);

    [[nodiscard]] QStringList entries() const;
    void add(const QStringList& files, const ReadSettings& reading = {});
    void clear();

    /// How an entry was read. Empty text: as usual, or a list that an older version wrote.
    [[nodiscard]] ReadSettings readingOf(const QString& entry) const;
    [[nodiscard]] QString readingTextOf(const QString& entry) const;

    static QStringList filesOf(const QString& entry);
    static QString nameOf(const QString& entry);  ///< for a menu: the file's name, "and 2 more"

private:
    void keepReading(const QStringList& entries, const QString& newest, const ReadSettings& reading);

    QSettings& settings_;
};

}  // namespace noonmark
