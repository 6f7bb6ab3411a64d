(** Expressions, their derivative along a vector field, and their values.

    Nothing here is particular to one paper. A vector field gives the derivative of
    each variable as an expression, and [along] differentiates by structural recursion. *)

From Coq Require Import ZArith List.
Import ListNotations.

(** * Expressions *)

Inductive expr : Type :=
| Var (n : nat)
| Num (z : Z)
| Add (a b : expr)
| Opp (a : expr)
| Mul (a b : expr)
| Div (a b : expr)
| Pow (a : expr) (n : nat).

Definition Sub (a b : expr) := Add a (Opp b).

Declare Scope expr_scope.
Delimit Scope expr_scope with expr.
Bind Scope expr_scope with expr.
Infix "+" := Add : expr_scope.
Infix "-" := Sub : expr_scope.
Infix "*" := Mul : expr_scope.
Infix "/" := Div : expr_scope.
Notation "- a" := (Opp a) : expr_scope.
Notation "a ^ n" := (Pow a n%nat) : expr_scope.

Definition num_of_Z (z : Z) : expr := Num z.
Definition Z_of_num (e : expr) : option Z := match e with Num z => Some z | _ => None end.
Number Notation expr num_of_Z Z_of_num : expr_scope.
Open Scope expr_scope.

(** The derivative, when the variable [n] changes by [rate n]. *)

Fixpoint along (rate : nat -> expr) (e : expr) : expr :=
  match e with
  | Var n => rate n
  | Num _ => 0
  | Add a b => along rate a + along rate b
  | Opp a => - along rate a
  | Mul a b => along rate a * b + a * along rate b
  | Div a b => along rate a / b - a * along rate b / (b * b)
  | Pow a O => 0
  | Pow a (S n) => Num (Z.of_nat (S n)) * a ^ n * along rate a
  end.

(** Other expressions for the variables: a change of variables, a conjugation. *)

Fixpoint subst (image : nat -> expr) (e : expr) : expr :=
  match e with
  | Var n => image n
  | Num z => Num z
  | Add a b => subst image a + subst image b
  | Opp a => - subst image a
  | Mul a b => subst image a * subst image b
  | Div a b => subst image a / subst image b
  | Pow a n => subst image a ^ n
  end.

(** A list of expressions, for the variables in their order. *)

Definition each (images : list expr) (n : nat) : expr := nth n images 0.

(** * Vectors *)

Definition vec : Type := (expr * expr * expr)%type.

Definition fst3 (u : vec) : expr := let '(a, _, _) := u in a.
Definition snd3 (u : vec) : expr := let '(_, b, _) := u in b.
Definition thd3 (u : vec) : expr := let '(_, _, c) := u in c.

Definition map3 (f : expr -> expr) (u : vec) : vec := (f (fst3 u), f (snd3 u), f (thd3 u)).

Definition zip3 (f : expr -> expr -> expr) (u v : vec) : vec :=
  (f (fst3 u) (fst3 v), f (snd3 u) (snd3 v), f (thd3 u) (thd3 v)).

Definition dot (u v : vec) : expr := fst3 u * fst3 v + snd3 u * snd3 v + thd3 u * thd3 v.

Definition cross (u v : vec) : vec :=
  (snd3 u * thd3 v - thd3 u * snd3 v,
   thd3 u * fst3 v - fst3 u * thd3 v,
   fst3 u * snd3 v - snd3 u * fst3 v).

(** * Simpler expressions with the same value

    Derivatives have many zeros, which [simple] takes away. [plain] also writes quotients
    as products, for divisors with a known inverse; what is left is polynomial. *)

Definition sum (a b : expr) : expr :=
  match a, b with
  | Num 0, _ => b
  | _, Num 0 => a
  | _, _ => a + b
  end.

Definition prod (a b : expr) : expr :=
  match a, b with
  | Num 0, _ => 0
  | _, Num 0 => 0
  | Num 1, _ => b
  | _, Num 1 => a
  | _, _ => a * b
  end.

Definition quot (a b : expr) : expr :=
  match a, b with
  | Num 0, _ => 0
  | _, Num 1 => a
  | _, _ => a / b
  end.

Fixpoint simple (e : expr) : expr :=
  match e with
  | Var n => Var n
  | Num z => Num z
  | Add a b => sum (simple a) (simple b)
  | Opp a => match simple a with Num 0 => 0 | a => - a end
  | Mul a b => prod (simple a) (simple b)
  | Div a b => quot (simple a) (simple b)
  | Pow a n => simple a ^ n
  end.

Fixpoint same (a b : expr) : bool :=
  match a, b with
  | Var n, Var m => Nat.eqb n m
  | Num y, Num z => Z.eqb y z
  | Add a b, Add c d | Mul a b, Mul c d | Div a b, Div c d => same a c && same b d
  | Opp a, Opp b => same a b
  | Pow a n, Pow b m => same a b && Nat.eqb n m
  | _, _ => false
  end.

(** Divisors, each with its inverse. *)

Definition table : Type := list (expr * expr).

Fixpoint lookup (known : table) (e : expr) : option expr :=
  match known with
  | [] => None
  | (b, c) :: rest => if same (simple b) e then Some c else lookup rest e
  end.

Fixpoint inverse (known : table) (e : expr) : option expr :=
  match lookup known e with
  | Some c => Some c
  | None =>
    match e with
    | Num 1 => Some 1
    | Opp a => option_map Opp (inverse known a)
    | Mul a b =>
      match inverse known a, inverse known b with
      | Some c, Some d => Some (c * d)
      | _, _ => None
      end
    | Pow a n => option_map (fun c => c ^ n) (inverse known a)
    | _ => None
    end
  end.

Fixpoint undivided (known : table) (e : expr) : expr :=
  match e with
  | Var n => Var n
  | Num z => Num z
  | Add a b => undivided known a + undivided known b
  | Opp a => - undivided known a
  | Mul a b => undivided known a * undivided known b
  | Div a b =>
    match inverse known b with
    | Some c => prod (undivided known a) c
    | None => undivided known a / undivided known b
    end
  | Pow a n => undivided known a ^ n
  end.

Definition plain (known : table) (e : expr) : expr := undivided known (simple e).
