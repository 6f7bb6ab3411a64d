(** Expressions, their derivative along a vector field, and their values.

    Nothing here is particular to one paper. A field of expressions gives the
    derivative of each variable; [along] differentiates by structural recursion.
    Values are taken in any field in which 2 is not 0, and at points with Gaussian
    rational coordinates, where they are computed. *)

From Coq Require Import ZArith QArith List Field.

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

(** The derivative, when the variable [n] changes by [rate n]. *)

Fixpoint along (rate : nat -> expr) (e : expr) : expr :=
  match e with
  | Var n => rate n
  | Num _ => Num 0
  | Add a b => Add (along rate a) (along rate b)
  | Opp a => Opp (along rate a)
  | Mul a b => Add (Mul (along rate a) b) (Mul a (along rate b))
  | Div a b => Div (Sub (Mul (along rate a) b) (Mul a (along rate b))) (Mul b b)
  | Pow a 0 => Num 0
  | Pow a (S n) => Mul (Mul (Num (Z.of_nat (S n))) (Pow a n)) (along rate a)
  end.

(** Other expressions for the variables: changes of variables, the conjugation. *)

Fixpoint subst (image : nat -> expr) (e : expr) : expr :=
  match e with
  | Var n => image n
  | Num z => Num z
  | Add a b => Add (subst image a) (subst image b)
  | Opp a => Opp (subst image a)
  | Mul a b => Mul (subst image a) (subst image b)
  | Div a b => Div (subst image a) (subst image b)
  | Pow a n => Pow (subst image a) n
  end.

(** Expressions for the first variables, from a list; all others stay [rest]. *)

Definition from (images : list expr) (rest : nat -> expr) (n : nat) : expr :=
  nth n images (rest n).

Definition constant (n : nat) : expr := Num 0.

(** Derivatives have many zeros; this takes them away, and [simplified] below says that
    values stay. *)

Definition sum (a b : expr) : expr :=
  match a, b with
  | Num 0, _ => b
  | _, Num 0 => a
  | _, _ => Add a b
  end.

Definition prod (a b : expr) : expr :=
  match a, b with
  | Num 0, _ => Num 0
  | _, Num 0 => Num 0
  | Num 1, _ => b
  | _, Num 1 => a
  | _, _ => Mul a b
  end.

Definition quot (a b : expr) : expr :=
  match a, b with
  | Num 0, _ => Num 0
  | _, Num 1 => a
  | _, _ => Div a b
  end.

Fixpoint simple (e : expr) : expr :=
  match e with
  | Var n => Var n
  | Num z => Num z
  | Add a b => sum (simple a) (simple b)
  | Opp a => match simple a with Num 0 => Num 0 | a => Opp a end
  | Mul a b => prod (simple a) (simple b)
  | Div a b => quot (simple a) (simple b)
  | Pow a n => Pow (simple a) n
  end.

(** * Vectors *)

Definition vec : Type := (expr * expr * expr)%type.

Definition fst3 (u : vec) : expr := let '(a, _, _) := u in a.
Definition snd3 (u : vec) : expr := let '(_, b, _) := u in b.
Definition thd3 (u : vec) : expr := let '(_, _, c) := u in c.

Definition map3 (f : expr -> expr) (u : vec) : vec := (f (fst3 u), f (snd3 u), f (thd3 u)).

Definition zip3 (f : expr -> expr -> expr) (u v : vec) : vec :=
  (f (fst3 u) (fst3 v), f (snd3 u) (snd3 v), f (thd3 u) (thd3 v)).

Definition dot (u v : vec) : expr :=
  Add (Add (Mul (fst3 u) (fst3 v)) (Mul (snd3 u) (snd3 v))) (Mul (thd3 u) (thd3 v)).

Definition cross (u v : vec) : vec :=
  (Sub (Mul (snd3 u) (thd3 v)) (Mul (thd3 u) (snd3 v)),
   Sub (Mul (thd3 u) (fst3 v)) (Mul (fst3 u) (thd3 v)),
   Sub (Mul (fst3 u) (snd3 v)) (Mul (snd3 u) (fst3 v))).

(** * Values in a field *)

Section Values.

Variable R : Type.
Variables zero one : R.
Variables add mul sub : R -> R -> R.
Variable opp : R -> R.
Variable div : R -> R -> R.
Variable inv : R -> R.
Variable R_field : field_theory zero one add mul sub opp div inv (@eq R).

Fixpoint positive_value (p : positive) : R :=
  match p with
  | xH => one
  | xO p => mul (add one one) (positive_value p)
  | xI p => add one (mul (add one one) (positive_value p))
  end.

Definition integer_value (z : Z) : R :=
  match z with
  | Z0 => zero
  | Zpos p => positive_value p
  | Zneg p => opp (positive_value p)
  end.

Fixpoint power_value (x : R) (n : nat) : R :=
  match n with
  | O => one
  | S O => x
  | S n => mul x (power_value x n)
  end.

Fixpoint value (v : nat -> R) (e : expr) : R :=
  match e with
  | Var n => v n
  | Num z => integer_value z
  | Add a b => add (value v a) (value v b)
  | Opp a => opp (value v a)
  | Mul a b => mul (value v a) (value v b)
  | Div a b => div (value v a) (value v b)
  | Pow a n => power_value (value v a) n
  end.

Add Field R_as_field : R_field.

Lemma root_nonzero (s r : R) : mul s s = r -> r <> zero -> s <> zero.
Proof. intros H N E. apply N. rewrite <- H, E. ring. Qed.

Lemma product_nonzero (a b : R) : a <> zero -> b <> zero -> mul a b <> zero.
Proof.
  intros A B E. apply B.
  transitivity (mul (div one a) (mul a b)).
  - field. exact A.
  - rewrite E. ring.
Qed.

Lemma opposite_nonzero (a : R) : a <> zero -> opp a <> zero.
Proof.
  intros A E. apply A. transitivity (opp (opp a)).
  - ring.
  - rewrite E. ring.
Qed.

Lemma sum_value (v : nat -> R) (a b : expr) :
  value v (sum a b) = add (value v a) (value v b).
Proof.
  unfold sum; destruct a as [|[| |]| | | | |]; try (cbn; ring);
  destruct b as [|[| |]| | | | |]; cbn; ring.
Qed.

Lemma prod_value (v : nat -> R) (a b : expr) :
  value v (prod a b) = mul (value v a) (value v b).
Proof.
  unfold prod; destruct a as [|[|[| |]|]| | | | |]; try (cbn; ring);
  destruct b as [|[|[| |]|]| | | | |]; cbn; ring.
Qed.

Lemma quot_value (v : nat -> R) (a b : expr) :
  value v (quot a b) = div (value v a) (value v b).
Proof.
  assert (Z : forall x, div zero x = zero).
  { intros x. rewrite (Fdiv_def R_field). ring. }
  assert (O : forall x, div x one = x).
  { intros x. field. exact (F_1_neq_0 R_field). }
  unfold quot; destruct a as [|[| |]| | | | |]; cbn [value integer_value]; auto;
  destruct b as [|[|[| |]|]| | | | |]; cbn [value integer_value positive_value]; auto.
Qed.

Lemma simple_value (v : nat -> R) (e : expr) : value v (simple e) = value v e.
Proof.
  induction e as [n|z|a A b B|a A|a A b B|a A b B|a A n]; cbn [simple].
  - reflexivity.
  - reflexivity.
  - rewrite sum_value, A, B. reflexivity.
  - cbn [value]. rewrite <- A. destruct (simple a) as [|[| |]| | | | |]; cbn; ring.
  - rewrite prod_value, A, B. reflexivity.
  - rewrite quot_value, A, B. reflexivity.
  - cbn [value]. rewrite A. reflexivity.
Qed.

Lemma simplified (v : nat -> R) (a b : expr) :
  value v (simple a) = value v (simple b) -> value v a = value v b.
Proof. rewrite !simple_value. auto. Qed.

(** A term of a combination vanishes where a given equation holds. *)

Lemma vanishing (v : nat -> R) (s c a b : expr) :
  value v a = value v b -> value v (Add s (Mul c (Sub a b))) = value v s.
Proof. intros E. cbn [value Sub]. rewrite E. ring. Qed.

End Values.

(** * Values at Gaussian rational points, computed *)

Definition gauss : Type := (Q * Q)%type.

Definition gadd (x y : gauss) : gauss := (Qred (fst x + fst y), Qred (snd x + snd y)).
Definition gopp (x : gauss) : gauss := (Qred (- fst x), Qred (- snd x)).
Definition gmul (x y : gauss) : gauss :=
  (Qred (fst x * fst y - snd x * snd y), Qred (fst x * snd y + snd x * fst y)).
Definition gdiv (x y : gauss) : gauss :=
  let n := (fst y * fst y + snd y * snd y)%Q in
  gmul x (Qred (fst y / n), Qred (- snd y / n)).

Fixpoint gpow (x : gauss) (n : nat) : gauss :=
  match n with O => (1, 0)%Q | S n => gmul x (gpow x n) end.

Fixpoint at_point (v : nat -> gauss) (e : expr) : gauss :=
  match e with
  | Var n => v n
  | Num z => (inject_Z z, 0%Q)
  | Add a b => gadd (at_point v a) (at_point v b)
  | Opp a => gopp (at_point v a)
  | Mul a b => gmul (at_point v a) (at_point v b)
  | Div a b => gdiv (at_point v a) (at_point v b)
  | Pow a n => gpow (at_point v a) n
  end.

Definition same (x y : gauss) : Prop := (fst x == fst y)%Q /\ (snd x == snd y)%Q.

(** The point with these coordinates. *)

Definition point (values : list gauss) (n : nat) : gauss := nth n values (0, 0)%Q.
