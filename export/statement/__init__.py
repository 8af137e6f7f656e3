"""The statement, problem.md, in the forms that judges take: LaTeX, PDF, HTML, figures."""
