// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The one row of figures that validation and mesher leave in a table, for programs and for people.

#ifndef featurehex_Figures_h
#define featurehex_Figures_h

#include <string>
#include <utility>
#include <vector>

class vtkTable;

namespace featurehex
{
/// All numbers of the row under their column names, in order. Empty without a row.
std::vector<std::pair<std::string, double>> FiguresOf(vtkTable* table);

/// 0 where there is no such column.
double FigureOf(vtkTable* table, const char* name);

/// Empty where there is no such column.
std::string TextOf(vtkTable* table, const char* name);

/// One line for each promise: kept or broken, and the numbers behind it.
std::string PromiseTable(vtkTable* table);

/// "12345 hexes, scaled Jacobian >= 0.55 (mean 0.85), Hausdorff distance <= 0.43 % of the
/// diagonal".
std::string SummaryLine(vtkTable* table);
} // namespace featurehex

#endif
