// SPDX-License-Identifier: BSD-3-Clause
// Poisson's equation on a mesh of ours in deal.II, with a solution that is known: prints the number
// of cells, the error in L2 and H1, and area and mean place of each boundary id.
#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>

using namespace dealii;

namespace
{
/// u = sin(x + 0.3) cos(2 y) exp(z / 2); -div grad u = (1 + 4 - 1/4) u.
class Solution : public Function<3>
{
public:
  double value(const Point<3>& p, unsigned int = 0) const override
  {
    return std::sin(p[0] + 0.3) * std::cos(2.0 * p[1]) * std::exp(0.5 * p[2]);
  }
  Tensor<1, 3> gradient(const Point<3>& p, unsigned int = 0) const override
  {
    const double s = std::sin(p[0] + 0.3), c = std::cos(2.0 * p[1]), e = std::exp(0.5 * p[2]);
    Tensor<1, 3> result;
    result[0] = std::cos(p[0] + 0.3) * c * e;
    result[1] = -2.0 * s * std::sin(2.0 * p[1]) * e;
    result[2] = 0.5 * s * c * e;
    return result;
  }
};

void PrintBoundary(const Triangulation<3>& mesh)
{
  std::map<types::boundary_id, std::pair<double, Point<3>>> sides;
  const QGauss<2> quadrature(2);
  const FE_Q<3> element(1);
  FEFaceValues<3> values(
    element, quadrature, update_JxW_values | update_quadrature_points);
  for (const auto& cell : mesh.active_cell_iterators())
  {
    for (const unsigned int f : cell->face_indices())
    {
      if (cell->face(f)->at_boundary())
      {
        values.reinit(cell, f);
        auto& [area, place] = sides[cell->face(f)->boundary_id()];
        for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          area += values.JxW(q);
          place += values.JxW(q) * values.quadrature_point(q);
        }
      }
    }
  }
  for (const auto& [id, side] : sides)
  {
    std::cout << "boundary " << id << " " << side.first << " " << side.second / side.first << "\n";
  }
}
} // namespace

int main(int, char** arguments)
{
  Triangulation<3> mesh;
  GridIn<3> reader(mesh);
  std::ifstream file(arguments[1]);
  reader.read_ucd(file);
  PrintBoundary(mesh);

  const FE_Q<3> element(1);
  DoFHandler<3> dofs(mesh);
  dofs.distribute_dofs(element);
  const Solution solution;
  AffineConstraints<double> constraints;
  for (const types::boundary_id id : mesh.get_boundary_ids())
  {
    VectorTools::interpolate_boundary_values(dofs, id, solution, constraints);
  }
  constraints.close();
  DynamicSparsityPattern pattern(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, pattern, constraints, false);
  SparsityPattern sparsity;
  sparsity.copy_from(pattern);
  SparseMatrix<double> matrix(sparsity);
  Vector<double> right(dofs.n_dofs()), u(dofs.n_dofs());

  const QGauss<3> quadrature(3);
  FEValues<3> values(element, quadrature,
    update_values | update_gradients | update_quadrature_points | update_JxW_values);
  const unsigned int count = element.n_dofs_per_cell();
  FullMatrix<double> cellMatrix(count, count);
  Vector<double> cellRight(count);
  std::vector<types::global_dof_index> indices(count);
  for (const auto& cell : dofs.active_cell_iterators())
  {
    values.reinit(cell);
    cellMatrix = 0;
    cellRight = 0;
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const double f = 4.75 * solution.value(values.quadrature_point(q));
      for (unsigned int i = 0; i < count; ++i)
      {
        cellRight(i) += f * values.shape_value(i, q) * values.JxW(q);
        for (unsigned int j = 0; j < count; ++j)
        {
          cellMatrix(i, j) +=
            values.shape_grad(i, q) * values.shape_grad(j, q) * values.JxW(q);
        }
      }
    }
    cell->get_dof_indices(indices);
    constraints.distribute_local_to_global(cellMatrix, cellRight, indices, matrix, right);
  }
  SolverControl control(2000, 1e-12 * right.l2_norm());
  SolverCG<Vector<double>> solver(control);
  PreconditionSSOR<SparseMatrix<double>> preconditioner;
  preconditioner.initialize(matrix, 1.2);
  solver.solve(matrix, u, right, preconditioner);
  constraints.distribute(u);

  std::cout << "cells " << mesh.n_active_cells() << "\n";
  for (const auto& [name, norm] : { std::pair("L2", VectorTools::L2_norm),
         { "H1", VectorTools::H1_seminorm } })
  {
    Vector<float> errors(mesh.n_active_cells());
    VectorTools::integrate_difference(dofs, u, solution, errors, QGauss<3>(4), norm);
    std::cout << name << " " << VectorTools::compute_global_error(mesh, errors, norm) << "\n";
  }
  return 0;
}
