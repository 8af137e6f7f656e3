"""The picture that explains one scenario: `explain_picture`."""

from pictures.explain.picture import explain_picture

__all__ = ["explain_picture"]
